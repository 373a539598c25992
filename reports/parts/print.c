/* print.c - prints the assumptions for a room, and wraps text to a width. */
#include "reports/parts/print.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "reports/parts/format.h"
#include "model/light/photographs/sky_picture.h"
#include "model/light/rough/rough_finishes.h"
#include "model/room/corrections.h"
#include "model/base/text.h"
#include "model/room/outside/trees.h"

enum { LABEL = 15, TEXT_BYTES = 512 };

void pp_print_title(const struct pp_world *world, const char *file, FILE *out)
{
    const char *shown = strcmp(file, "-") == 0 ? "standard input" : file;
    if (world->name && *world->name) {
        pp_format_utf8_put(out, world->name);
        fputs("  (", out);
        pp_format_utf8_put(out, shown);
        fputs(")\n", out);
    } else {
        pp_format_utf8_put(out, shown);
        fputc('\n', out);
    }
}

void pp_print_wrapped(const char *text, int column, int indent, int width, FILE *out)
{
    bool first = true;
    for (text += strspn(text, " "); *text; text += strspn(text, " ")) {
        char word[TEXT_BYTES];
        int length = (int)strcspn(text, " ");
        snprintf(word, sizeof word, "%.*s", length, text);
        int columns = pp_format_utf8_width(word);
        if (!first && column + 1 + columns > width) {
            fprintf(out, "\n%*s", indent, "");
            column = indent;
        } else if (!first) {
            fputc(' ', out);
            column++;
        }
        pp_format_utf8_put(out, word);
        column += columns;
        text += length;
        first = false;
    }
    fputc('\n', out);
}

/* Callback that receives the facts, and the callback's data. */
struct listener {
    pp_print_fact *tell;
    void *closure;
};

static void tell(const struct listener *listener, const char *label, const char *format,
                 ...) __attribute__((format(printf, 3, 4)));
static void tell(const struct listener *listener, const char *label, const char *format,
                 ...)
{
    char text[TEXT_BYTES];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    listener->tell(listener->closure, label, text);
}

static void tell_picture(const struct pp_sky_picture *picture,
                         const struct listener *listener)
{
    tell(listener, "sky", "photograph %s, %.0f lx on a horizontal plane",
         picture->title, picture->horizontal_lx);
    if (picture->filled >= 5e-4)
        tell(listener, "",
             "%.1f %% of this light is from directions missing from the photograph, "
             "which were filled in",
             100.0 * picture->filled);
    if (picture->saturated)
        tell(listener, "",
             "%d pixels have the largest value, %.3g cd/m2: a sun there is clipped",
             picture->saturated, picture->peak_cd_m2);
}

static void tell_sky(const struct pp_world *world, const struct pp_outside_light *light,
                     const struct listener *listener)
{
    const struct pp_sky *sky = &light->sky;
    if (sky->kind == PP_SKY_OVERCAST) {
        tell(listener, "sky", "CIE standard overcast");
    } else if (sky->kind == PP_SKY_UNIFORM) {
        tell(listener, "sky", "uniform");
    } else if (sky->kind == PP_SKY_PICTURE) {
        tell_picture(sky->picture, listener);
    } else if (!pp_sky_iso_has_sun(sky->iso)) {
        tell(listener, "sky", "ISO 15469 type %d", sky->iso);
    } else {
        double bearing = atan2(sky->sun.x, sky->sun.y) + world->north_rad;
        bearing = fmod(bearing / PP_RAD + 720.0, 360.0);
        tell(listener, "sky",
             "ISO 15469 type %d, sun %.3g deg high, bearing %.4g deg; without the "
             "sun's disc",
             sky->iso, asin(sky->sun.z) / PP_RAD, bearing);
    }
}

static void tell_size(const struct pp_world *world, const struct listener *listener)
{
    struct pp_vec3 low = pp_vec(INFINITY, INFINITY, INFINITY);
    struct pp_vec3 high = pp_vec(-INFINITY, -INFINITY, -INFINITY);
    double all_m2 = 0.0;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_surface *face = &world->surfaces[i];
        for (int j = 0; j < face->outline.count; j++) {
            struct pp_vec3 v = face->outline.vertices[j];
            low = pp_vec(fmin(low.x, v.x), fmin(low.y, v.y), fmin(low.z, v.z));
            high = pp_vec(fmax(high.x, v.x), fmax(high.y, v.y), fmax(high.z, v.z));
        }
        all_m2 += face->outline.area_m2;
    }
    tell(listener, "room",
         "%.2f x %.2f m, %.2f m high; floor %.1f m2, all surfaces %.1f m2",
         high.x - low.x, high.y - low.y, high.z - low.z, pp_world_floor_m2(world),
         all_m2);
}

/* Appends a reflectance, "floor 0.20", or "floor 0.20 to 0.35" if the faces differ. */
static void append_reflectance(const struct pp_world *world, enum pp_role role,
                               const char *name, char text[TEXT_BYTES])
{
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < world->face_count; i++)
        if (world->surfaces[i].role == role) {
            low = fmin(low, world->surfaces[i].front);
            high = fmax(high, world->surfaces[i].front);
        }
    if (low > high)
        return;
    pp_text_append(text, TEXT_BYTES, "%s%s %.3g", *text ? ", " : "", name, low);
    if (high > low)
        pp_text_append(text, TEXT_BYTES, " to %.3g", high);
}

/* Appends the range of the mean reflectances of the surfaces with the pattern. */
static void append_means(const struct pp_world *world,
                         const struct pp_rough_finish *material, char text[TEXT_BYTES])
{
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < world->surface_count; i++)
        if (world->surfaces[i].finish == &material->finish
            && world->surfaces[i].pattern_mean > 0.0) {
            low = fmin(low, world->surfaces[i].front);
            high = fmax(high, world->surfaces[i].front);
        }
    if (low > high)
        return;
    pp_text_append(text, TEXT_BYTES, ", %.3g ", low);
    if (high > low)
        pp_text_append(text, TEXT_BYTES, "to %.3g ", high);
    bool even = strcmp(material->pattern.text, "1") == 0;
    pp_text_append(text, TEXT_BYTES, "on average with its %s",
                   !material->has_bumps ? "pattern"
                   : even               ? "bumps"
                                        : "pattern and bumps");
}

/* Passes on each material of the room file: its reflectance, its mean reflectance with
 * a pattern, and the light lost by roughness. */
static void tell_materials(const struct pp_world *world,
                           const struct listener *listener)
{
    for (int i = 0; i < pp_rough_finishes_count(world->materials); i++) {
        const struct pp_rough_finish *material =
            pp_rough_finishes_at(world->materials, i);
        char text[TEXT_BYTES] = "";
        pp_text_append(text, TEXT_BYTES, "%s reflects %.3g", material->finish.name,
                       material->finish.reflectance);
        if (material->has_pattern)
            append_means(world, material, text);
        if (!material->is_matt)
            pp_text_append(text, TEXT_BYTES, ", and loses %.1f %% by roughness",
                           100.0 * material->surface.lost);
        tell(listener, i == 0 ? "materials" : "", "%s", text);
    }
}

static void tell_reflectances(const struct pp_world *world,
                              const struct listener *listener)
{
    char text[TEXT_BYTES] = "";
    append_reflectance(world, PP_FLOOR, "floor", text);
    append_reflectance(world, PP_WALL, "walls", text);
    append_reflectance(world, PP_CEILING, "ceiling", text);
    if (world->decorations != 1.0)
        pp_text_append(text, TEXT_BYTES,
                       "; reflected light multiplied by %.3g for deterioration of "
                       "decorations",
                       world->decorations);
    tell(listener, "reflectances", "%s", text);
}

/* Appends a measured pane, and the glass that hand methods use in its place. */
static void tell_measured(char *text, const struct pp_measured_pane *pane)
{
    static const char *const kinds[] = {
        [PP_MEASURED_CLEAR] = "clear for hand methods",
        [PP_MEASURED_DIFFUSING] = "diffusing for hand methods",
        [PP_MEASURED_SCATTERING] = "too directional for most hand methods"};
    pp_text_append(text, TEXT_BYTES,
                   "; measured pane %.60s, transmittance %.3f normal, %.3f "
                   "hemispherical, of which %.0f %% unscattered; %s",
                   pane->file ? pane->file : pane->name, pane->normal, pane->diffuse,
                   100.0 * pane->straight_diffuse / pane->diffuse, kinds[pane->kind]);
}

/* Describes the assumptions for an opening, without its position along the wall. */
static void describe_opening(const struct pp_world *world,
                             const struct pp_opening *opening, char text[TEXT_BYTES])
{
    double sill = INFINITY;
    for (int i = 0; i < opening->inner.count; i++)
        sill = fmin(sill, opening->inner.vertices[i].z);
    const struct pp_surface *face = &world->surfaces[opening->face];
    double slope = opening->slope_rad / PP_RAD;

    text[0] = '\0';
    pp_text_append(text, TEXT_BYTES, "%s: ",
                   face->name                 ? face->name
                   : face->role == PP_CEILING ? "ceiling"
                                              : "envelope");
    pp_text_append(text, TEXT_BYTES, "%.2f x %.2f m", opening->width_m,
                   opening->height_m);
    if (!opening->rectangle)
        pp_text_append(text, TEXT_BYTES, " overall, area %.2f m2",
                       opening->inner.area_m2);
    if (slope < 0.5)
        pp_text_append(text, TEXT_BYTES, ", horizontal at %.2f m", sill);
    else if (slope < 89.5)
        pp_text_append(text, TEXT_BYTES, ", slope %.0f deg, lower edge at %.2f m",
                       slope, sill);
    else
        pp_text_append(text, TEXT_BYTES, ", sill %.2f m", sill);
    if (opening->reveal_m > 0.0)
        pp_text_append(text, TEXT_BYTES, ", reveal %.2f m", opening->reveal_m);

    const struct pp_glass *glass = &opening->glass;
    if (opening->measured)
        tell_measured(text, opening->measured);
    else if (glass->panes == 0)
        pp_text_append(text, TEXT_BYTES, "; unglazed");
    else if (glass->diffusing)
        pp_text_append(text, TEXT_BYTES, "; diffusing, transmittance %.3g",
                       glass->diffuse);
    else
        pp_text_append(
            text, TEXT_BYTES, "; %d pane%s, normal transmittance %.2f, diffuse %.2f",
            glass->panes, glass->panes > 1 ? "s" : "", glass->normal, glass->diffuse);
    pp_text_append(text, TEXT_BYTES, "; frame factor %.3g, maintenance %.3g",
                   opening->frame_factor, opening->maintenance);
    if (opening->maintenance_is_auto)
        pp_text_append(text, TEXT_BYTES, " (%s)", pp_corrections_editions[world->dirt]);
    if (opening->curtains != 1.0)
        pp_text_append(text, TEXT_BYTES, ", curtains transmit %.3g", opening->curtains);
    pp_window_device_say(&opening->device, text, TEXT_BYTES, " deg");
}

/* Passes on the openings. Openings with the same description are grouped. */
static void tell_openings(const struct pp_world *world, const struct listener *listener)
{
    for (int i = 0; i < world->opening_count; i++) {
        char text[TEXT_BYTES], other[TEXT_BYTES];
        describe_opening(world, &world->openings[i], text);
        int same = 0;
        bool said = false;
        for (int j = 0; j < world->opening_count && !said; j++) {
            describe_opening(world, &world->openings[j], other);
            bool equal = strcmp(text, other) == 0;
            said = equal && j < i;
            same += equal;
        }
        if (said)
            continue;
        char label[LABEL + 8] = "opening";
        if (same > 1)
            snprintf(label, sizeof label, "%d openings", same);
        tell(listener, label, "%s", text);
    }
    if (world->opening_count == 0)
        tell(listener, "openings", "none");
}

/* Appends the number of meshes, or of outlines, and of their triangles, which is
 * returned. */
static int append_meshes(const struct pp_world *world, bool outlines,
                         char text[TEXT_BYTES])
{
    int count = 0, triangles = 0;
    for (int i = 0; i < world->mesh_count; i++)
        if (world->meshes[i].is_outline == outlines) {
            count++;
            triangles += world->meshes[i].side_count;
        }
    if (count > 0)
        pp_text_append(text, TEXT_BYTES, "; %d %s%s of %d triangle%s", count,
                       outlines ? "outline" : "mesh",
                       count == 1 ? ""
                       : outlines ? "s"
                                  : "es",
                       triangles, triangles > 1 ? "s" : "");
    return triangles;
}

static void tell_outside(const struct pp_world *world,
                         const struct pp_outside_light *light,
                         const struct listener *listener)
{
    char text[TEXT_BYTES] = "";
    pp_text_append(text, TEXT_BYTES, "ground %.3g", light->ground_reflectance);
    for (int i = 0; i < world->skyline_count; i++) {
        const struct pp_skyline *line = &world->skylines[i];
        const char *wall = world->surfaces[line->face].name;
        pp_text_append(text, TEXT_BYTES, "; skyline %.3g deg beyond %s",
                       line->angle_rad / PP_RAD, wall ? wall : "the wall");
        if (isfinite(line->distance_m))
            pp_text_append(text, TEXT_BYTES, ", %.3g m away", line->distance_m);
        pp_text_append(text, TEXT_BYTES, ", reflectance %.3g", line->reflectance);
    }
    for (int i = 0; i < world->facade_count; i++) {
        const struct pp_facade *facade = &world->facades[i];
        const char *wall = world->surfaces[facade->face].name;
        pp_text_append(text, TEXT_BYTES, "; facade %s, reflectance %.3g",
                       wall ? wall : "of the wall", facade->reflectance);
    }
    if (world->block_count > 0)
        pp_text_append(text, TEXT_BYTES, "; %d block%s", world->block_count,
                       world->block_count > 1 ? "s" : "");
    int loose = 0;
    for (int i = 0; i < pp_world_before_meshes(world); i++)
        loose +=
            world->surfaces[i].role == PP_FREE_SURFACE && !world->surfaces[i].inside;
    loose -= world->coarse_surface_count;
    if (loose > 0)
        pp_text_append(text, TEXT_BYTES, "; %d surface%s", loose, loose > 1 ? "s" : "");
    int triangles =
        append_meshes(world, false, text) + append_meshes(world, true, text);
    if (world->tree_count > 0)
        pp_text_append(text, TEXT_BYTES, "; %d tree%s%s", world->tree_count,
                       world->tree_count > 1 ? "s" : "",
                       !pp_trees_change(world) ? ""
                       : world->trees_are_bare ? ", without leaves"
                                               : ", with leaves");
    if (world->skyline_count + world->block_count + loose + triangles
                + world->tree_count
            == 0
        && !world->within)
        pp_text_append(text, TEXT_BYTES, "; no obstruction");
    tell(listener, "outside", "%s", text);
}

/* Passes on the coarse model in which the room is nested, if there is one. */
static void tell_within(const struct pp_world *world, const struct listener *listener)
{
    int panes = pp_world_coarse_panes(world);
    if (!world->within)
        return;
    const char *name = world->within->name ? world->within->name : "coarse model";
    if (world->within_is_before)
        tell(listener, "within", "%s, in front of the windows; %d surface%s, %d pane%s",
             name, world->coarse_surface_count,
             world->coarse_surface_count == 1 ? "" : "s", panes, panes == 1 ? "" : "s");
    else
        tell(listener, "within", "%s, with its outside; %d surface%s", name,
             world->coarse_surface_count, world->coarse_surface_count == 1 ? "" : "s");
}

void pp_print_facts(const struct pp_world *world, const struct pp_outside_light *light,
                    pp_print_fact *fact, void *closure)
{
    const struct listener listener = {fact, closure};
    tell_sky(world, light, &listener);
    tell_size(world, &listener);
    tell_reflectances(world, &listener);
    tell_materials(world, &listener);
    tell_openings(world, &listener);
    tell_outside(world, light, &listener);
    tell_within(world, &listener);
    tell(&listener, "working plane", "at %.2f m; averages cover the whole plane",
         world->working_plane_m);
}

struct lines {
    FILE *out;
    int width;
};

/* Prints a fact: " label the fact, wrapped". */
static void print_fact(void *closure, const char *label, const char *text)
{
    const struct lines *lines = closure;
    fprintf(lines->out, "  %-*s", LABEL, label);
    pp_print_wrapped(text, LABEL + 2, LABEL + 2, lines->width, lines->out);
}

void pp_print_assumed(const struct pp_world *world,
                      const struct pp_outside_light *light, int width, FILE *out)
{
    struct lines lines = {out, width};
    pp_print_facts(world, light, print_fact, &lines);
}
