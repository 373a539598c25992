/* gbxml_envelope.c - see gbxml_envelope.h. */
#include "formats/gbxml/gbxml_envelope.h"

#include <math.h>

#include "formats/gbxml/gbxml_prism.h"

/* WELD_M: tolerance (m) of the second attempt to weld corners. weld_share: greatest
 * allowed change of volume by the second attempt, as a fraction of the volume. */
#define WELD_M 0.02
static const double weld_share = 0.01;

/* Limits above which notes report moved corners (m), and deviations from Area and
 * Volume (fractions). */
static const double noted_m = 5e-3, noted_share = 0.03;

enum envelope_source { BY_SURFACES, BY_SHELL, BY_PRISM };

struct envelope_choice {
    struct pp_gbxml_shell shell;
    enum envelope_source source;
    double off; /* deviation from Area and Volume; INFINITY: no shell yet */
};

static double share_off(double value, double given)
{
    double off = isnan(given) ? 0.0 : fabs(value / given - 1.0);
    return off <= noted_share ? 0.0 : off;
}

/* Larger of the relative deviations from the space's Area and Volume; deviations up to
 * 3 % count as 0. */
static double envelope_off(const struct pp_gbxml_shell *shell,
                           const struct pp_gbxml_space *space)
{
    return fmax(share_off(pp_gbxml_shell_floor_area(shell), space->area_m2),
                share_off(shell->volume_m3, space->volume_m3));
}

/* Keeps the shell if it matches Area and Volume better than the one in `choice`; else
 * clears it. */
static void offer(struct envelope_choice *choice, struct pp_gbxml_shell *shell,
                  enum envelope_source source, const struct pp_gbxml_space *space)
{
    double off = envelope_off(shell, space);
    if (!(off < choice->off)) {
        pp_gbxml_shell_clear(shell);
        return;
    }
    pp_gbxml_shell_clear(&choice->shell);
    *choice = (struct envelope_choice){*shell, source, off};
}

/* Makes a shell of the surfaces or of the ShellGeometry and offers it to `choice`. A
 * shell closed by added faces is offered to `lacking` instead; the caller uses
 * `lacking` only if it matches Area and Volume better. *why keeps the reason of the
 * first failure. */
static enum pp_status try_polygons(struct envelope_choice *choice,
                                   struct envelope_choice *lacking, const char **why,
                                   const struct pp_gbxml_envelope_parts *parts,
                                   enum envelope_source source, double weld,
                                   struct pp_error *err)
{
    struct pp_gbxml_shell shell;
    const char *fault;
    const bool surfaces = source == BY_SURFACES;
    const struct pp_gbxml_space *space = parts->space;
    if (!surfaces && space->shell_count == 0)
        return PP_OK;
    enum pp_status status =
        pp_gbxml_shell_make(&shell, &fault, surfaces ? parts->polygons : space->shell,
                            surfaces ? parts->count : space->shell_count, weld, err);
    if (status == PP_OK && !fault && weld > PP_GBXML_SAME_M
        && shell.moved_m3 > weld_share * shell.volume_m3)
        fault = "can only be closed by changes that alter its volume";
    if (status == PP_OK && !fault)
        offer(shell.lacking > 0 ? lacking : choice, &shell, source, space);
    else
        pp_gbxml_shell_clear(&shell);
    if (!*why)
        *why = fault;
    return status;
}

/* True if all faces are horizontal or vertical. */
static bool is_upright(const struct pp_gbxml_shell *shell)
{
    for (int i = 0; i < shell->face_count; i++) {
        struct pp_vec3 normal = pp_gbxml_shell_normal(shell, i);
        double level = hypot(normal.x, normal.y), up = fabs(normal.z);
        if (level > 0.01 * up && up > 0.01 * level)
            return false;
    }
    return true;
}

static enum pp_status try_prism(struct envelope_choice *choice,
                                const struct pp_gbxml_envelope_parts *parts,
                                struct pp_clipper *clipper, struct pp_error *err)
{
    struct pp_gbxml_shell shell;
    const char *fault;
    if (isfinite(choice->off) && !is_upright(&choice->shell))
        return PP_OK;
    enum pp_status status =
        pp_gbxml_prism_make(&shell, &fault, parts->space, parts->polygons, parts->count,
                            parts->openings_top_m, clipper, err);
    if (status == PP_OK && !fault)
        offer(choice, &shell, BY_PRISM, parts->space);
    else
        pp_gbxml_shell_clear(&shell);
    return status;
}

/* Notes the source of the envelope, and the changes made to it. */
static void note_choice(const struct envelope_choice *choice, bool closes,
                        const struct pp_gbxml_space *space, struct pp_mistakes *notes)
{
    const struct pp_gbxml_shell *shell = &choice->shell;
    if (choice->source != BY_SURFACES)
        pp_mistakes_add(notes, space->line,
                        "space \"%.60s\": its surfaces %s, so %s is used instead",
                        space->id,
                        closes ? "do not match its Area and Volume" : "do not close",
                        choice->source == BY_SHELL ? "its ShellGeometry"
                                                   : "a vertical prism over its floor");
    if (shell->moved_m > noted_m)
        pp_mistakes_add(notes, space->line,
                        "space \"%.60s\": corners up to %.0f mm apart were merged",
                        space->id, 1e3 * shell->moved_m);
    if (shell->lacking > 0)
        pp_mistakes_add(notes, space->line,
                        "space \"%.60s\" is open and was closed by adding %d plane %s",
                        space->id, shell->lacking,
                        shell->lacking == 1 ? "face" : "faces");
}

static void note_difference(const struct pp_gbxml_shell *shell,
                            const struct pp_gbxml_space *space,
                            struct pp_mistakes *notes)
{
    double area = pp_gbxml_shell_floor_area(shell);
    if (share_off(area, space->area_m2) > 0.0)
        pp_mistakes_add(
            notes, space->line,
            "space \"%.60s\": the floor measures %.4g m2, but its Area is %.4g m2",
            space->id, area, space->area_m2);
    if (share_off(shell->volume_m3, space->volume_m3) > 0.0)
        pp_mistakes_add(notes, space->line,
                        "space \"%.60s\": the enclosed volume is %.4g m3, but its "
                        "Volume is %.4g m3",
                        space->id, shell->volume_m3, space->volume_m3);
}

enum pp_status pp_gbxml_envelope_make(struct pp_gbxml_shell *shell, const char **why,
                                      bool *by_surfaces,
                                      const struct pp_gbxml_envelope_parts *parts,
                                      struct pp_clipper *clipper,
                                      struct pp_mistakes *notes, struct pp_error *err)
{
    static const double welds[] = {PP_GBXML_SAME_M, WELD_M};
    struct envelope_choice choice = {.off = INFINITY}, lacking = choice;
    enum pp_status status = PP_OK;
    bool closes = false;
    *why = NULL;
    for (int i = 0; i < 4 && status == PP_OK && choice.off > 0.0; i++) {
        status = try_polygons(&choice, &lacking, why, parts,
                              i < 2 ? BY_SURFACES : BY_SHELL, welds[i % 2], err);
        closes |= i < 2 && isfinite(choice.off);
    }
    if (lacking.off < choice.off)
        offer(&choice, &lacking.shell, lacking.source, parts->space);
    else
        pp_gbxml_shell_clear(&lacking.shell);
    if (status == PP_OK && choice.off > 0.0)
        status = try_prism(&choice, parts, clipper, err);
    if (isfinite(choice.off))
        *why = NULL;
    if (status == PP_OK && !*why) {
        note_choice(&choice, closes, parts->space, notes);
        note_difference(&choice.shell, parts->space, notes);
    }
    *by_surfaces = choice.source == BY_SURFACES;
    *shell = choice.shell;
    return status;
}
