/* import_report.c - prints an imported scene and its sensor readings as text, JSON or
 * CSV. */
#include "reports/import_report.h"

#include <math.h>
#include <string.h>

#include "reports/parts/format.h"
#include "reports/parts/json.h"
#include "reports/parts/print.h"
#include "reports/parts/table.h"
#include "model/base/read_file.h"

/* Converts an irradiance (W/m2) to an illuminance (lx). */
static double lux(double irradiance)
{
    return PP_IMPORT_EFFICACY * irradiance;
}

static double factor(const struct pp_imported *imported, double irradiance)
{
    double horizontal = pp_rgb_luminance(imported->horizontal);
    return horizontal > 0.0 ? 100.0 * irradiance / horizontal : NAN;
}

/* ---- counts of the scene's parts ---- */

struct census {
    long shapes[PP_SHAPE_DISTANT + 1];
    long suns; /* distant sources of small angular size */
    struct pp_vec3 low, high;
    bool bounded;
};

static void stretch(struct census *census, struct pp_vec3 v, double by)
{
    struct pp_vec3 *low = &census->low, *high = &census->high;
    if (!census->bounded)
        *low = *high = v;
    census->bounded = true;
    *low =
        pp_vec(fmin(low->x, v.x - by), fmin(low->y, v.y - by), fmin(low->z, v.z - by));
    *high = pp_vec(fmax(high->x, v.x + by), fmax(high->y, v.y + by),
                   fmax(high->z, v.z + by));
}

static struct census count(const struct pp_scene_description *scene)
{
    struct census census = {.bounded = false};
    for (int i = 0; i < scene->vertex_count; i++)
        stretch(&census, scene->vertices[i], 0.0);
    for (int i = 0; i < scene->shape_count; i++) {
        const struct pp_shape *shape = &scene->shapes[i];
        census.shapes[shape->kind]++;
        switch (shape->kind) {
        case PP_SHAPE_SPHERE:
            stretch(&census, shape->is.sphere.centre, shape->is.sphere.radius_m);
            break;
        case PP_SHAPE_CONE:
            for (int k = 0; k < 2; k++)
                stretch(&census, shape->is.cone.ends[k], shape->is.cone.radii_m[k]);
            break;
        case PP_SHAPE_RING:
            stretch(&census, shape->is.ring.centre, shape->is.ring.radii_m[1]);
            break;
        case PP_SHAPE_DISTANT:
            census.suns +=
                scene->materials[shape->material].emits == PP_EMITS_CONCENTRATED;
            break;
        case PP_SHAPE_POLYGON:
            break;
        }
    }
    return census;
}

static void print_summary(const struct pp_imported *imported, FILE *out)
{
    const struct pp_scene_description *scene = imported->scene;
    struct census census = count(scene);
    fprintf(out, "Scene of");
    for (int i = 0; i < imported->file_count; i++) {
        fputc(' ', out);
        pp_format_utf8_put(out, pp_read_file_title(imported->files[i]));
    }
    fprintf(out, "\n\n  polygons          %ld, with %d corners\n",
            census.shapes[PP_SHAPE_POLYGON], scene->vertex_count);
    static const char *const names[] = {[PP_SHAPE_SPHERE] = "spheres",
                                        [PP_SHAPE_CONE] = "cones, cylinders",
                                        [PP_SHAPE_RING] = "rings"};
    for (int kind = PP_SHAPE_SPHERE; kind <= PP_SHAPE_RING; kind++)
        if (census.shapes[kind] > 0)
            fprintf(out, "  %-17s %ld\n", names[kind], census.shapes[kind]);
    fprintf(out, "  distant sources   %ld", census.shapes[PP_SHAPE_DISTANT]);
    fprintf(out, census.suns ? " (concentrated: %ld)\n" : "\n", census.suns);
    fprintf(out, "  materials         %d\n", scene->material_count);
    if (imported->summary.flat > 0)
        fprintf(out, "  ignored           %ld polygons of zero area\n",
                imported->summary.flat);
    if (imported->summary.unseen > 0)
        fprintf(out, "  ignored           %ld shapes made of void (no material)\n",
                imported->summary.unseen);
    if (census.bounded)
        fprintf(
            out,
            "  from              %.6g %.6g %.6g\n  to                %.6g %.6g %.6g\n",
            census.low.x, census.low.y, census.low.z, census.high.x, census.high.y,
            census.high.z);
    double horizontal = pp_rgb_luminance(imported->horizontal);
    if (horizontal > 0.0)
        fprintf(
            out,
            "  open level ground %.6g lx under the sky of the scene, without the sun\n",
            lux(horizontal));
    else
        fprintf(out, "  open level ground no sky, so there are no daylight factors\n");
}

/* ---- text ---- */

enum { COLUMNS = 7 };

static double imported_cell(const struct pp_imported *imported, int row, int column)
{
    const struct pp_sensor *point = &imported->points[row];
    const struct pp_sensor_reading *reading = &imported->readings[row];
    switch (column) {
    case 0:
        return point->position.x;
    case 1:
        return point->position.y;
    case 2:
        return point->position.z;
    case 3:
        return lux(reading->grey);
    case 4:
        return lux(reading->grey_error);
    case 5:
        return factor(imported, reading->grey);
    default:
        return factor(imported, reading->grey_error);
    }
}

static bool print_table(const struct pp_imported *imported, int width, bool utf8,
                        FILE *out)
{
    static const char *const headings[COLUMNS] = {"x", "y", "z", "lx", "", "DF %", ""};
    static const char *const formats[COLUMNS] = {"%.3f", "%.3f", "%.3f", "%.4g",
                                                 "%.2g", "%.4g", "%.2g"};
    static const char illuminance[] = "illuminance", daylight[] = "daylight factor";
    struct pp_table table;
    pp_table_init(&table, imported->count);
    bool good = true;
    for (int i = 0; i < COLUMNS && good; i++) {
        if (i >= 5 && !isfinite(factor(imported, 0.0)))
            break;
        const char *group = i < 3 ? NULL : i < 5 ? illuminance : daylight;
        const char *heading = headings[i][0] ? headings[i] : utf8 ? "\xc2\xb1" : "+-";
        struct pp_table_column *column = pp_table_add(&table, group, group, heading);
        good = column != NULL;
        for (int row = 0; good && row < imported->count; row++) {
            double value = imported_cell(imported, row, i);
            if (isfinite(value))
                snprintf(column->cells[row], PP_CELL_BYTES, formats[i], value + 0.0);
            else
                snprintf(column->cells[row], PP_CELL_BYTES, "-");
        }
    }
    table.key_count = 3;
    if (good)
        pp_table_print(&table, width, out);
    pp_table_clear(&table);
    return good;
}

static enum pp_status print_text(const struct pp_imported *imported, int width,
                                 bool utf8, FILE *out, struct pp_error *err)
{
    if (imported->summarised)
        print_summary(imported, out);
    if (!imported->readings)
        return PP_OK;
    if (imported->summarised)
        fputc('\n', out);
    if (!print_table(imported, width, utf8, out))
        return pp_fail_memory(err);
    fprintf(out, "\n  ");
    char text[300];
    double horizontal = pp_rgb_luminance(imported->horizontal);
    if (horizontal > 0.0)
        snprintf(
            text, sizeof text,
            "Simulated by path tracing, with standard errors. Illuminances use 179 "
            "lm/W; daylight factors are relative to the %.6g lx on open level ground.",
            lux(horizontal));
    else
        snprintf(
            text, sizeof text,
            "Simulated by path tracing, with standard errors. Illuminances use 179 "
            "lm/W. There are no daylight factors, because the scene has no sky.");
    pp_print_wrapped(text, 2, 2, width, out);
    if (imported->by_clock)
        fprintf(out, "  Stopped at the --time limit; another run may differ.\n");
    if (!imported->finished)
        fprintf(out, "  Interrupted: not finished.\n");
    return PP_OK;
}

/* ---- JSON ---- */

static bool add_corner_json(struct json_object *object, const char *key,
                            struct pp_vec3 v)
{
    return pp_json_numbers(object, key, (double[]){v.x, v.y, v.z}, 3);
}

static bool add_rgb(struct json_object *object, const char *key, struct pp_rgb rgb)
{
    return pp_json_numbers(object, key, (double[]){rgb.r, rgb.g, rgb.b}, 3);
}

static bool add_imported_value(struct json_object *object, const char *key,
                               double value, double error)
{
    struct json_object *entry = json_object_new_object();
    if (!pp_json_add(object, key, entry))
        return false;
    pp_json_on_one_line(entry);
    return pp_json_number(entry, "value", value) && pp_json_number(entry, "se", error);
}

static struct json_object *point_object(const struct pp_imported *imported, int which)
{
    const struct pp_sensor *point = &imported->points[which];
    const struct pp_sensor_reading *reading = &imported->readings[which];
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_number(object, "x", point->position.x)
                && pp_json_number(object, "y", point->position.y)
                && pp_json_number(object, "z", point->position.z)
                && pp_json_number(object, "dx", point->normal.x)
                && pp_json_number(object, "dy", point->normal.y)
                && pp_json_number(object, "dz", point->normal.z)
                && add_rgb(object, "irradiance", reading->irradiance)
                && add_rgb(object, "irradiance-se", reading->std_error)
                && add_imported_value(object, "lux", lux(reading->grey),
                                      lux(reading->grey_error))
                && add_imported_value(object, "df", factor(imported, reading->grey),
                                      factor(imported, reading->grey_error));
    if (good)
        pp_json_on_one_line(object);
    return pp_json_whole(object, good);
}

static bool add_summary(struct json_object *object, const struct pp_imported *imported)
{
    struct census census = count(imported->scene);
    struct json_object *scene = json_object_new_object();
    bool good = scene
                && pp_json_number(scene, "polygons", census.shapes[PP_SHAPE_POLYGON])
                && pp_json_number(scene, "corners", imported->scene->vertex_count)
                && pp_json_number(scene, "spheres", census.shapes[PP_SHAPE_SPHERE])
                && pp_json_number(scene, "cones", census.shapes[PP_SHAPE_CONE])
                && pp_json_number(scene, "rings", census.shapes[PP_SHAPE_RING])
                && pp_json_number(scene, "distant", census.shapes[PP_SHAPE_DISTANT])
                && pp_json_number(scene, "materials", imported->scene->material_count)
                && pp_json_number(scene, "flat", imported->summary.flat)
                && pp_json_number(scene, "void", imported->summary.unseen)
                && add_corner_json(scene, "from", census.low)
                && add_corner_json(scene, "to", census.high);
    return pp_json_add(object, "scene", pp_json_whole(scene, good));
}

static bool add_imported_points(struct json_object *object,
                                const struct pp_imported *imported)
{
    struct json_object *array = json_object_new_array();
    bool good = pp_json_add(object, "points", array);
    for (int i = 0; i < imported->count && good; i++)
        good = pp_json_append(array, point_object(imported, i));
    return good;
}

static enum pp_status print_json(const struct pp_imported *imported, FILE *out,
                                 struct pp_error *err)
{
    struct json_object *object = json_object_new_object();
    double horizontal = pp_rgb_luminance(imported->horizontal);
    bool good = object && pp_json_text(object, "format", "pepperpot-import-1");
    if (good && imported->summarised)
        good = add_summary(object, imported);
    if (good)
        good = pp_json_number(object, "horizontal-lux",
                              horizontal > 0.0 ? lux(horizontal) : NAN);
    if (good && imported->readings)
        good =
            pp_json_add(object, "finished", json_object_new_boolean(imported->finished))
            && add_imported_points(object, imported);
    return pp_json_print(out, pp_json_whole(object, good), err);
}

/* ---- CSV ---- */

static void print_csv(const struct pp_imported *imported, FILE *out)
{
    fputs("x,y,z,dx,dy,dz,red,green,blue,red_se,green_se,blue_se,lux,lux_se,df,df_se,"
          "finished\r\n",
          out);
    for (int i = 0; i < imported->count; i++) {
        const struct pp_sensor *point = &imported->points[i];
        const struct pp_sensor_reading *r = &imported->readings[i];
        const double numbers[] = {point->position.y,
                                  point->position.z,
                                  point->normal.x,
                                  point->normal.y,
                                  point->normal.z,
                                  r->irradiance.r,
                                  r->irradiance.g,
                                  r->irradiance.b,
                                  r->std_error.r,
                                  r->std_error.g,
                                  r->std_error.b,
                                  lux(r->grey),
                                  lux(r->grey_error),
                                  factor(imported, r->grey),
                                  factor(imported, r->grey_error)};
        fprintf(out, "%.10g", point->position.x + 0.0);
        for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++)
            pp_format_csv_number(numbers[k], out);
        fprintf(out, ",%s\r\n", imported->finished ? "yes" : "no");
    }
}

enum pp_status pp_import_report(const struct pp_imported *imported,
                                enum pp_format format, int width, bool utf8, FILE *out,
                                struct pp_error *err)
{
    switch (format) {
    case PP_FORMAT_JSON:
        return print_json(imported, out, err);
    case PP_FORMAT_CSV:
        print_csv(imported, out);
        return PP_OK;
    case PP_FORMAT_TEXT:
        break;
    }
    return print_text(imported, width, utf8, out, err);
}
