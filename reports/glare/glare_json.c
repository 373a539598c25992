/* glare_json.c - see glare_json.h. */
#include "reports/glare/glare_json.h"

#include <stdio.h>

#include "reports/parts/json.h"

static bool add_glare_value(struct json_object *to, const char *key,
                            const struct pp_annual_value *value)
{
    struct json_object *line = json_object_new_object();
    if (!pp_json_add(to, key, line))
        return false;
    pp_json_on_one_line(line);
    return pp_json_number(line, "value", value->value)
           && pp_json_number(line, "se", value->std_error);
}

static bool append_source(struct json_object *to, const char *source, double omega_sr,
                          double cd_m2, double index, double sum)
{
    struct json_object *line = json_object_new_object();
    if (!pp_json_append(to, line))
        return false;
    pp_json_on_one_line(line);
    return pp_json_text(line, "source", source)
           && pp_json_number(line, "solid_angle_sr", omega_sr)
           && pp_json_number(line, "luminance_cd_m2", cd_m2)
           && pp_json_number(line, "position_index", index)
           && pp_json_number(line, "sum", sum);
}

static bool add_moment_of_view(struct json_object *to,
                               const struct pp_glare_sheet *sheet,
                               const struct pp_glare_moment *moment)
{
    struct json_object *sources = json_object_new_array();
    bool good = add_glare_value(to, "eye_illuminance_lux", &moment->eye_lx)
                && add_glare_value(to, "dgp", &moment->dgp)
                && pp_json_text(to, "class", pp_glare_sheet_class(moment->dgp.value))
                && pp_json_number(to, "sum", moment->sum);
    good = pp_json_add(to, "sources", sources) && good;
    for (int k = 0; k < moment->part_count && good; k++) {
        const struct pp_glare_part *part = &moment->parts[k];
        if (part->omega_sr > 0.0)
            good = append_source(sources,
                                 k < sheet->world->opening_count
                                     ? sheet->world->openings[k].label
                                     : "room",
                                 part->omega_sr, pp_glare_sheet_luminance(part),
                                 pp_glare_sheet_index(part), part->sum);
    }
    if (good && moment->sun.visible)
        good = append_source(sources, "sun", moment->sun.omega_sr, moment->sun.cd_m2,
                             moment->sun.index, moment->sun.sum);
    return good;
}

static bool add_year_of_view(struct json_object *to, const struct pp_glare_sheet *sheet,
                             const struct pp_glare_year *year)
{
    bool good = true;
    for (int i = 0; i < PP_GLARE_LIMITS && good; i++) {
        char key[32];
        snprintf(key, sizeof key, "hours_above_%.2f", pp_glare_sheet_limits[i]);
        good = add_glare_value(to, key, &year->above_h[i]);
    }
    return good && pp_json_number(to, "dgp_exceeded_in_5_per_cent", year->exceeded_in_5)
           && pp_json_number(to, "dgp_max", year->most)
           && pp_json_number(to, "sun_in_view_hours", year->sun_h)
           && pp_json_text(to, "en17037",
                           pp_glare_sheet_level(year, sheet->annual.occupied_h));
}

static bool add_glare_views(struct json_object *to, const struct pp_glare_sheet *sheet)
{
    struct json_object *views = json_object_new_array();
    bool good = pp_json_add(to, "views", views);
    for (int v = 0; v < sheet->view_count && good; v++) {
        const struct pp_world_view *of = &sheet->views[v];
        struct json_object *view = json_object_new_object();
        good =
            pp_json_append(views, view)
            && (!of->name || pp_json_text(view, "view", of->name))
            && pp_json_number(view, "x", of->eye.x)
            && pp_json_number(view, "y", of->eye.y)
            && pp_json_number(view, "z", of->eye.z)
            && pp_json_number(view, "bearing_deg", of->bearing_rad / PP_RAD)
            && (sheet->is_year ? add_year_of_view(view, sheet, &sheet->years[v])
                               : add_moment_of_view(view, sheet, &sheet->moments[v]));
    }
    return good;
}

static struct json_object *glare_room(const void *all, int index)
{
    const struct pp_glare_results *results = all;
    const struct pp_glare_sheet *sheet = &results->list[index].sheet;
    const struct pp_annual_sheet *annual = &sheet->annual;
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_text(object, "format", "pepperpot-glare-1")
                && pp_json_text(object, "room", sheet->world->name)
                && pp_json_text(object, "weather", annual->weather);
    if (sheet->is_year)
        good = good && pp_json_text(object, "period", annual->period)
               && pp_json_number(object, "occupied_hours", annual->occupied_h);
    else
        good =
            good && (!results->when || pp_json_text(object, "when", results->when))
            && pp_json_text(object, "sky", annual->sky_name)
            && pp_json_number(object, "sun_altitude_deg",
                              annual->hours[0].sun_altitude_rad / PP_RAD)
            && pp_json_number(object, "sun_bearing_deg",
                              annual->hours[0].sun_bearing_rad / PP_RAD)
            && pp_json_number(object, "diffuse_horizontal_lux",
                              annual->hours[0].diffuse_lx)
            && pp_json_number(object, "direct_normal_lux", annual->hours[0].direct_lx);
    good = good
           && pp_json_number(object, "source_threshold_cd_m2", sheet->threshold_cd_m2);
    struct json_object *warnings = json_object_new_array();
    good = pp_json_add(object, "warnings", warnings) && good;
    for (int i = 0; i < annual->warning_count && good; i++)
        good = pp_json_append(warnings, json_object_new_string(annual->warnings[i]));
    return pp_json_whole(object, good && add_glare_views(object, sheet));
}

enum pp_status pp_glare_json(const struct pp_glare_results *results, FILE *out,
                             struct pp_error *err)
{
    return pp_json_print_rooms(out, glare_room, results, results->count,
                               results->several, err);
}
