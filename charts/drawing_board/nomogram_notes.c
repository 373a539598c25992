/* nomogram_notes.c - the text on a nomogram: title, instructions, letters, formulae,
 * and a room's readings.
 */
#include "charts/drawing_board/nomogram_notes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "charts/sheet/page.h"
#include "model/geometry/vec.h"
#include "model/base/text.h"
#include "model/results/step_text.h"

const char *pp_nomogram_notes_stem_label(const struct pp_nomogram *nomogram, int stem)
{
    switch (nomogram->stems[stem].quantity) {
    case PP_NOMOGRAM_GLASS:
        return nomogram->kind == PP_NOMOGRAM_POSITION ? "TW/A" : "W/A";
    case PP_NOMOGRAM_REFLECTANCE:
        return "R";
    case PP_NOMOGRAM_OBSTRUCTION:
        return "\u03b1, degrees";
    case PP_NOMOGRAM_SLOPE:
        return "\u03b2, degrees";
    case PP_NOMOGRAM_WALLS:
        return "walls";
    case PP_NOMOGRAM_LOSS:
        return "R";
    case PP_NOMOGRAM_GAIN:
        return "A/(1 \u2212 R)";
    case PP_NOMOGRAM_LIGHT:
        return "L, %";
    case PP_NOMOGRAM_FACTOR:
        return "f";
    case PP_NOMOGRAM_PLACE:
        return "x/d, 2y/w";
    case PP_NOMOGRAM_COMPONENT:
        break;
    }
    if (stem == nomogram->edges[PP_NOMOGRAM_EDGES - 1].read)
        return nomogram->kind == PP_NOMOGRAM_POSITION ? "IRC, %" : "min., %";
    if (nomogram->kind == PP_NOMOGRAM_POSITION)
        return "mean, %";
    return "IRC, %";
}

static const char *const numbers[PP_NOMOGRAMS] = {
    [PP_NOMOGRAM_AVERAGE] = "I",
    [PP_NOMOGRAM_MINIMUM] = "II",
    [PP_NOMOGRAM_ROOFLIGHT] = "III",
    [PP_NOMOGRAM_POSITION] = "IV",
};

void pp_nomogram_notes_title(char *text, size_t room,
                             const struct pp_nomogram_sheet *sheet)
{
    snprintf(text, room, "Nomogram %s", numbers[sheet->nomogram.kind]);
}

void pp_nomogram_notes_subtitle(char *text, size_t room,
                                const struct pp_nomogram_sheet *sheet)
{
    static const char *const what[PP_NOMOGRAMS] = {
        [PP_NOMOGRAM_AVERAGE] = "average internally reflected component, side-lit room",
        [PP_NOMOGRAM_MINIMUM] =
            "average and minimum internally reflected component, side-lit room",
        [PP_NOMOGRAM_ROOFLIGHT] =
            "average internally reflected component, top-lit room",
        [PP_NOMOGRAM_POSITION] =
            "internally reflected component at a point, side-lit room",
    };
    *text = 0;
    if (!sheet->blank)
        pp_page_say(text, room, "Nomogram %s:", numbers[sheet->nomogram.kind]);
    pp_page_say(text, room, "%s; CIE overcast sky%s", what[sheet->nomogram.kind],
                sheet->nomogram.kind == PP_NOMOGRAM_POSITION ? ""
                                                             : ", clear single glass");
}

void pp_nomogram_notes_instructions(char *text, size_t room,
                                    const struct pp_nomogram *nomogram)
{
    bool top = nomogram->kind == PP_NOMOGRAM_ROOFLIGHT;
    *text = 0;
    if (nomogram->kind == PP_NOMOGRAM_POSITION) {
        pp_page_say(text, room,
                    "Lay a straight-edge from A to B and read C. Lay it from C to D "
                    "and read E, the mean over the working plane. Lay it from H "
                    "through q and read F, once for the depth and once for the "
                    "position along the wall. Lay it from E to the product of both "
                    "readings on F and read G, the value at the point.");
        return;
    }
    pp_page_say(text, room,
                "Lay a straight-edge from A to B and read C, %s. Lay it from C to D "
                "and read E, %s.",
                top ? "for horizontal glass" : "without obstruction",
                top ? "for glass with that slope" : "with the obstruction");
    if (nomogram->kind == PP_NOMOGRAM_MINIMUM)
        pp_page_say(text, room,
                    "For the minimum, lay it from E to F and read G. Without "
                    "obstruction, use the value of C on scale E.");
}

/* --- the foot ------------------------------------------------------------------------
 */

static void say_position_letters(char *text, size_t room)
{
    pp_page_say(
        text, room,
        "A: diffuse transmittance T of the glass (clear single 0.83) times its net "
        "area W, divided by the area A of all interior surfaces. B: mean reflectance R "
        "of these surfaces, with 0.1 for openings. D: effective light L on the glass. "
        "H: position of the point. First use its distance x from the window wall, "
        "divided by the depth d of the room. Then use its distance y from the centre "
        "of the window along the wall, divided by half the width w.");
    pp_page_say(text, room,
                "If a value is off scale A, use ten times or a tenth of it, and move "
                "the decimal point of the result back. Multiply the result by a factor "
                "for dirt. Add the results of several windows.\n");
}

/* Appends the formulae that remain to be calculated on paper, in the printed units, and
 * explains their symbols. */
static void say_formulae(char *text, size_t room, const struct pp_nomogram_sheet *sheet)
{
    for (int i = 0; sheet->formulae[i]; i++) {
        const struct pp_formula *formula = sheet->formulae[i];
        char sum[512] = "";
        pp_step_text_add(sum, sizeof sum, formula->sum, (int)strlen(formula->sum),
                         true);
        pp_page_say(text, room, "%s = %s%s", formula->symbol, sum,
                    sheet->formulae[i + 1] ? ";" : ".");
    }
    pp_page_say(
        text, room,
        "V, C_b, C_g: light on the glass from the sky, from obstructions and from the "
        "ground, without shading. \u03c1_l, A_l, \u03c1_u, A_u: reflectance and area "
        "of the surfaces below and above the centre of the window. d, w, h: depth, "
        "width and height of the window with its reveal. d_r, w_r, h_r: those of the "
        "room. Formula irc-atlas, fitted to simulated rooms: pepperpot.");
}

static void say_letters(char *text, size_t room, const struct pp_nomogram *nomogram)
{
    bool top = nomogram->kind == PP_NOMOGRAM_ROOFLIGHT;
    pp_page_say(text, room,
                "A: net glass area W divided by the area A of all interior surfaces. "
                "B: mean reflectance R of these surfaces, with 0.1 for openings. C: "
                "average internally reflected component (IRC), %s.",
                top ? "horizontal glass" : "no obstruction");
    pp_page_say(
        text, room,
        top ? "D: slope \u03b2 of the glass (horizontal: 0). E: IRC for that slope."
            : "D: altitude \u03b1 of a long obstruction, seen from the centre of the "
              "window. E: IRC with this obstruction.");
    if (nomogram->kind == PP_NOMOGRAM_MINIMUM)
        pp_page_say(text, room,
                    "F: mean reflectance of the walls. G: minimum IRC, far from the "
                    "window. It is E divided by 1.8, 1.4, 1.3 or 1.2 for wall "
                    "reflectances of 0.2, 0.4, 0.6 or 0.8.");
    pp_page_say(text, room,
                "If W/A is off scale A, use ten times or a tenth of it, and move the "
                "decimal point of the IRC back. Multiply the IRC by factors for other "
                "glass and for dirt. Add the results of several windows.\n");
}

static void say_formula(char *text, size_t room, const struct pp_nomogram *nomogram)
{
    double k = nomogram->k, lower = nomogram->R_fw_R;
    if (nomogram->kind == PP_NOMOGRAM_ROOFLIGHT)
        pp_page_say(text, room,
                    "IRC = 0.85 W/(A (1 \u2212 R)) (C Rfw + 5 (1 \u2212 cos \u03b2) "
                    "Rcw) %%; C: light from the sky on the glass, 100 if horizontal; "
                    "ground reflectance 0.1; no obstruction;");
    else
        pp_page_say(text, room,
                    "IRC = 0.85 W/(A (1 \u2212 R)) (C Rfw + 5 Rcw) %%; C: 39 without "
                    "obstruction, else from the printed table;");
    pp_page_say(text, room,
                "rule Rcw = k Rfw, k = %.3g, and (Rfw + Rcw)/2 = R, so Rfw = "
                "%.3g\u00a0R and Rcw = %.3g\u00a0R. On average the rule is exact for "
                "reflectances of 0.2 (floor), 0.5 (walls) and 0.7 (ceiling).",
                k, lower, k * lower);
    pp_page_say(text, room,
                "BRE inter-reflection formula (Hopkinson, Longmore and Petherbridge, "
                "1954; BRE Digest 310, 1986); rule and construction of the scales: "
                "pepperpot.");
}

static void say_number(char *text, size_t room, const struct pp_nomogram_sheet *sheet,
                       int stem, double value)
{
    switch (sheet->nomogram.stems[stem].quantity) {
    case PP_NOMOGRAM_COMPONENT:
    case PP_NOMOGRAM_LIGHT:
        snprintf(text, room, "%.4g\u00a0%%", 100.0 * value);
        return;
    case PP_NOMOGRAM_OBSTRUCTION:
    case PP_NOMOGRAM_SLOPE:
        snprintf(text, room, "%.3g\u00b0", value / PP_RAD);
        return;
    default:
        snprintf(text, room, "%.4g", value);
    }
}

void pp_nomogram_notes_value(char *text, size_t room,
                             const struct pp_nomogram_sheet *sheet, int window,
                             int stem, bool briefly)
{
    char number[32];
    enum pp_nomogram_quantity quantity = sheet->nomogram.stems[stem].quantity;
    double value = sheet->windows[window].read.value[stem];
    if (quantity == PP_NOMOGRAM_COMPONENT || quantity == PP_NOMOGRAM_LIGHT)
        snprintf(number, sizeof number, "%.4g", 100.0 * value);
    else
        say_number(number, sizeof number, sheet, stem, value);
    bool of_room = quantity == PP_NOMOGRAM_REFLECTANCE || quantity == PP_NOMOGRAM_WALLS
                   || quantity == PP_NOMOGRAM_LOSS;
    if (sheet->window_count == 1 || of_room)
        snprintf(text, room, "%s", number);
    else if (briefly)
        snprintf(text, room, "%d", window + 1);
    else
        snprintf(text, room, "%d: %s", window + 1, number);
}

/* Appends the factors for both directions: "F 1.2 for the depth (H 0.3, q 0.92) and 1.1
 * along the wall (H 0.4, q 0.95);". */
static void say_places(char *text, size_t room,
                       const struct pp_nomogram_place places[2])
{
    pp_page_say(text, room,
                "F %.4g for the depth (H %.4g, q %.4g) and %.4g along the wall (H "
                "%.4g, q %.4g);",
                places[0].factor, places[0].share, places[0].q, places[1].factor,
                places[1].share, places[1].q);
}

/* Appends the readings of one window: "Window W1: W/A = 1.25/80.60 = 0.0155; A 0.0155
 * and B 0.522: C 0.54 %; ...". */
static void say_window(char *text, size_t room, const struct pp_nomogram_sheet *sheet,
                       int index)
{
    const struct pp_nomogram_window *window = &sheet->windows[index];
    const struct pp_nomogram_reading *read = &window->read;
    if (sheet->window_count > 1)
        pp_page_say(text, room, "%d.", index + 1);
    pp_page_say(text, room, "Window %s", window->label);
    if (window->alike > 1)
        pp_page_say(text, room, "and %d like it", window->alike - 1);
    char shift[40] = "";
    if (read->tens)
        snprintf(shift, sizeof shift, ", set %s %.0f",
                 read->tens > 0 ? "times" : "over", pow(10.0, abs(read->tens)));
    pp_text_append(text, room, ": %sW/A = %.2f/%.2f = %.4f%s;",
                   sheet->curve.count ? "T" : "", read->glass_m2, read->inside_m2,
                   read->ratio, shift);
    for (int k = 0; k < sheet->nomogram.edge_count; k++) {
        const struct pp_nomogram_edge *edge = &sheet->nomogram.edges[k];
        char words[3][32];
        if (!read->used[k])
            continue;
        say_number(words[0], 32, sheet, edge->from, read->value[edge->from]);
        say_number(words[1], 32, sheet, edge->to, read->value[edge->to]);
        say_number(words[2], 32, sheet, edge->read, read->value[edge->read]);
        if (k == 2 && sheet->curve.count)
            say_places(text, room, read->places);
        const struct pp_nomogram_stem *stems = sheet->nomogram.stems;
        if (k == 0)
            pp_page_say(text, room, "A %s and B %s: C %s;", words[0], words[1],
                        words[2]);
        else
            pp_page_say(text, room, "with %c %s: %c %s;", stems[edge->to].letter,
                        words[1], stems[edge->read].letter, words[2]);
    }
    double settled = window->allowance * read->component;
    char least[32] = "";
    if (isfinite(read->further))
        snprintf(least, sizeof least, " and %.3g\u00a0%%",
                 100.0 * window->allowance * read->further);
    pp_page_say(text, room, "\u00d7 %.3g for %sdirt = %.3g\u00a0%%%s%s.",
                window->allowance, sheet->curve.count ? "" : "its glass and ",
                100.0 * settled, least, window->alike > 1 ? " each" : "");
}

enum { WINDOWS_SAID = 6 };

static void say_room(char *text, size_t room, const struct pp_nomogram_sheet *sheet)
{
    for (int i = 0; i < sheet->window_count && i < WINDOWS_SAID; i++)
        say_window(text, room, sheet, i);
    if (sheet->window_count > WINDOWS_SAID)
        pp_page_say(text, room, "Further windows, not listed: %d.",
                    sheet->window_count - WINDOWS_SAID);
    if (sheet->decorations != 1.0)
        pp_page_say(text, room, "All \303\227 %.3g for deterioration of decorations.",
                    sheet->decorations);
    pp_page_say(text, room, "All windows together: average IRC %.3g\u00a0%%",
                100.0 * sheet->component);
    if (isfinite(sheet->further))
        pp_page_say(text, room, "and %s %.3g\u00a0%%",
                    sheet->curve.count ? "at the point" : "minimum",
                    100.0 * sheet->further);
    pp_page_say(text, room, "if read to a fifth of a division.");
    if (sheet->left_out)
        pp_page_say(
            text, room, "%d %s outside the scope of this nomogram.", sheet->left_out,
            sheet->left_out == 1 ? "further opening is" : "further openings are");
    pp_page_say(text, room, "\n");
}

void pp_nomogram_notes_foot(char *text, size_t room,
                            const struct pp_nomogram_sheet *sheet)
{
    *text = 0;
    if (!sheet->blank)
        say_room(text, room, sheet);
    if (sheet->formulae) {
        say_position_letters(text, room);
        say_formulae(text, room, sheet);
        return;
    }
    say_letters(text, room, &sheet->nomogram);
    say_formula(text, room, &sheet->nomogram);
}
