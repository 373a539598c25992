/* compare_averages.c - averages over the working plane by room formulae, compared with
 * traced averages in families of random rooms. Prints the manual's tables for wells,
 * for glass below the working plane, and for the efficiency method.
 *
 *     compare_averages [FAMILY [ROOMS]]
 *
 * For every method and class of rooms: number of rooms, bias and rms of the deviation in
 * per cent of the traced value, and bias of the sums. Rooms are traced to 0.5 % of their
 * average.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/bench.h"
#include "methods/evaluate.h"
#include "methods/reflected/well.h"
#include "simulate/sampling/hash.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/fast/tracer.h"

enum { MOST_ROOMS = 1000, MOST_METHODS = 16, MOST_CLASSES = 8, TEXT = 4096 };

static const double wanted_error = 0.005;

static double draw(uint64_t *series, double low, double high)
{
    *series = pp_hash(*series, 1);
    return low + (high - low) * (double)(*series >> 11) * 0x1p-53;
}

/* A family of rooms: a function that writes a random room, and the key that divides the
 * rooms into classes. */
struct family {
    const char *name, *what, *methods, *key;
    double (*write)(char *xml, uint64_t *series); /* returns the key */
    bool wells;                                   /* also compare the well efficiency N
                                                   * with rays */
    double classes[MOST_CLASSES];                 /* upper limits of the key,
                                                   * ascending */
};

static int write_box(char *xml, uint64_t *series, double size[3])
{
    size[0] = draw(series, 3.0, 8.0);
    size[1] = draw(series, 3.0, 8.0);
    size[2] = draw(series, 2.4, 4.0);
    return snprintf(xml, TEXT,
                    "<room version='1'><plan width='%.3f' depth='%.3f' height='%.3f'/>"
                    "<finishes floor='%.2f' walls='%.2f' ceiling='%.2f'/>",
                    size[0], size[1], size[2], draw(series, 0.1, 0.5),
                    draw(series, 0.3, 0.8), draw(series, 0.5, 0.9));
}

/* Writes a rooflight of 0.5 to 2 m in a horizontal ceiling, with a well of 0.05 to 2.5
 * m. */
static double write_well(char *xml, uint64_t *series)
{
    double size[3];
    int n = write_box(xml, series, size);
    double a = draw(series, 0.5, 2.0), b = draw(series, 0.5, 2.0);
    double deep = draw(series, 0.05, 2.5);
    snprintf(xml + n, (size_t)(TEXT - n),
             "<rooflight x='%.3f' y='%.3f' width='%.3f' depth='%.3f' reveal='%.3f'/>"
             "</room>",
             draw(series, 0.2, size[0] - a - 0.2), draw(series, 0.2, size[1] - b - 0.2),
             a, b, deep);
    const struct pp_well_shape shape = {a, b, deep, 0.5};
    return pp_well_index(&shape);
}

static int write_window(char *xml, int n, uint64_t *series, const double size[3],
                        double sill, double head)
{
    double wide = draw(series, 0.3, 0.95) * size[0];
    return n
           + snprintf(xml + n, (size_t)(TEXT - n),
                      "<window wall='south' left='%.3f' sill='%.3f' width='%.3f' "
                      "height='%.3f'/><facade wall='south' left='5' right='5' up='3' "
                      "down='0'/>",
                      draw(series, 0.02, 0.98) * (size[0] - wide), sill, wide,
                      head - sill);
}

/* Writes a window that begins below the working plane; the key is the fraction of the
 * window below the plane. */
static double write_low_glass(char *xml, uint64_t *series)
{
    double size[3];
    int n = write_box(xml, series, size);
    double sill = draw(series, 0.02, 0.75);
    double head = draw(series, 1.2, fmin(size[2] - 0.1, 2.6));
    n = write_window(xml, n, series, size, sill, head);
    snprintf(xml + n, (size_t)(TEXT - n), "</room>");
    return (0.85 - sill) / (head - sill);
}

/* Writes a window above the working plane, with a skyline in half of the rooms; the key
 * is the angle of the skyline (degrees). */
static double write_side(char *xml, uint64_t *series)
{
    double size[3];
    int n = write_box(xml, series, size);
    double sill = draw(series, 0.85, 1.3);
    n = write_window(xml, n, series, size, sill,
                     draw(series, sill + 0.6, size[2] - 0.05));
    bool open = draw(series, 0.0, 1.0) < 0.5;
    double angle = open ? 0.0 : draw(series, 5.0, 60.0);
    if (!open)
        n += snprintf(xml + n, (size_t)(TEXT - n),
                      "<skyline wall='south' angle='%.2f' distance='%.2f'/>", angle,
                      draw(series, 6.0, 30.0));
    snprintf(xml + n, (size_t)(TEXT - n), "</room>");
    return angle;
}

static int write_face(char *xml, int n, const char *role, const char *name,
                      const double (*v)[3], int count)
{
    n +=
        snprintf(xml + n, (size_t)(TEXT - n), "<face role='%s' name='%s'>", role, name);
    for (int i = 0; i < count; i++)
        n +=
            snprintf(xml + n, (size_t)(TEXT - n),
                     "<vertex x='%.4f' y='%.4f' z='%.4f'/>", v[i][0], v[i][1], v[i][2]);
    return n + snprintf(xml + n, (size_t)(TEXT - n), "</face>");
}

/* Writes a room under a mono-pitch roof that slopes down to the south, with a roof
 * window; the key is the slope (degrees). */
static double write_roof(char *xml, uint64_t *series)
{
    double w = draw(series, 3.0, 7.0), d = draw(series, 3.0, 6.0);
    double low = draw(series, 2.2, 3.0), slope_deg = draw(series, 3.0, 60.0);
    double rise = tan(slope_deg * PP_RAD), high = low + d * rise;
    const double floor[4][3] = {{0, 0, 0}, {w, 0, 0}, {w, d, 0}, {0, d, 0}};
    const double roof[4][3] = {{0, 0, low}, {0, d, high}, {w, d, high}, {w, 0, low}};
    const double south[4][3] = {{0, 0, 0}, {0, 0, low}, {w, 0, low}, {w, 0, 0}};
    const double north[4][3] = {{0, d, 0}, {w, d, 0}, {w, d, high}, {0, d, high}};
    const double west[4][3] = {{0, 0, 0}, {0, d, 0}, {0, d, high}, {0, 0, low}};
    const double east[4][3] = {{w, 0, 0}, {w, 0, low}, {w, d, high}, {w, d, 0}};
    int n = snprintf(xml, TEXT, "<room version='1'><envelope>");
    n = write_face(xml, n, "floor", "floor", floor, 4);
    n = write_face(xml, n, "ceiling", "roof", roof, 4);
    n = write_face(xml, n, "wall", "south", south, 4);
    n = write_face(xml, n, "wall", "north", north, 4);
    n = write_face(xml, n, "wall", "west", west, 4);
    n = write_face(xml, n, "wall", "east", east, 4);
    double x = draw(series, 0.1, 0.4) * w, across = draw(series, 0.2, 0.5) * w;
    double y = draw(series, 0.1, 0.4) * d, up = draw(series, 0.15, 0.45) * d;
    n += snprintf(xml + n, (size_t)(TEXT - n),
                  "</envelope><finishes floor='%.2f' walls='%.2f' ceiling='%.2f'/>"
                  "<opening>",
                  draw(series, 0.1, 0.5), draw(series, 0.3, 0.8),
                  draw(series, 0.5, 0.9));
    const double corners[4][2] = {
        {x, y}, {x, y + up}, {x + across, y + up}, {x + across, y}};
    for (int i = 0; i < 4; i++)
        n += snprintf(xml + n, (size_t)(TEXT - n),
                      "<vertex x='%.6f' y='%.6f' z='%.6f'/>", corners[i][0],
                      corners[i][1], low + corners[i][1] * rise);
    snprintf(xml + n, (size_t)(TEXT - n), "</opening></room>");
    return slope_deg;
}

static const struct family families[] = {
    {"wells",
     "rooflights with wells, by well index",
     "irc sphere,irc split-flux,irc arndt,irc k-factor,df exact+sphere,"
     "df exact+split-flux,df exact+arndt,df exact+k-factor,df average-df,df efficiency",
     "w",
     write_well,
     true,
     {0.25, 0.5, 1.0, 2.0, INFINITY}},
    {"low-glass",
     "windows from below the working plane, by the share of glass there",
     "df average-df,df average-df-above,df efficiency,df exact+bre",
     "share",
     write_low_glass,
     false,
     {0.2, 0.4, INFINITY}},
    {"side",
     "windows above the working plane, by the angle of the skyline",
     "df average-df,df efficiency,df exact+bre",
     "angle",
     write_side,
     false,
     {0.1, 30.0, INFINITY}},
    {"roofs",
     "roof windows, by slope",
     "df average-df,df efficiency,df exact+split-flux",
     "slope",
     write_roof,
     false,
     {20.0, 40.0, INFINITY}},
};

/* ---- one room ---- */

/* Traces the average of all components. */
static void trace(struct pp_reading readings[PP_COMPONENT_COUNT],
                  const struct pp_world *world, const struct pp_outside_light *light)
{
    struct pp_tracer_options options = {
        .error = wanted_error, .seed = 1, .threads = 1, .average = true};
    struct pp_light_scene *scene;
    struct pp_environment *environment;
    struct pp_tracer *tracer;
    struct pp_error err;
    must(pp_light_scene_of_world_matt(&scene, world, &err), &err);
    must(pp_light_scene_under(&environment, scene, light, &err), &err);
    must(pp_tracer_create(&tracer, scene, environment, NULL, 0, &options, &err), &err);
    while (!pp_tracer_done(tracer))
        must(pp_tracer_advance(tracer, 10.0, &err), &err);
    pp_tracer_read(tracer, -1, readings);
    pp_tracer_destroy(tracer);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
}

/* Splits a list of names, "df exact+bre" or "irc sphere"; returns their number. */
static int split_names(char *list, char *names[])
{
    int count = 0;
    for (char *name = strtok(list, ","); name; name = strtok(NULL, ","))
        names[count++] = name;
    return count;
}

static void evaluate(double values[], char *const names[], int count,
                     const struct pp_world *world, const struct pp_outside_light *light)
{
    struct pp_report report = {.world = world, .light = *light, .threads = 1};
    struct pp_error err;
    for (int i = 0; i < count; i++) {
        bool whole = strncmp(names[i], "df ", 3) == 0;
        const char *name = strchr(names[i], ' ') + 1;
        must(pp_methods_evaluate(&report, name, &err), &err);
        const struct pp_column *column =
            pp_report_find(&report, whole ? PP_DF : PP_IRC, name);
        values[i] = column ? column->average.value : NAN;
    }
    pp_report_clear(&report);
}

/* Well efficiency N of the room's rooflight, traced: all light from the well falls on a
 * plane just below the ceiling of a black room. `passed`: overcast-sky illuminance
 * transmitted by horizontal glass. */
static double traced_N(const struct pp_world *room, double *error)
{
    const struct pp_opening *opening = &room->openings[0];
    double ceiling = room->height_m, side = 2.2;
    char xml[TEXT];
    snprintf(xml, sizeof xml,
             "<room version='1'><plan width='%g' depth='%g' height='%.4f'/>"
             "<finishes floor='0' walls='0' ceiling='%.4f'/>"
             "<rooflight x='0.1' y='0.1' width='%.4f' depth='%.4f' reveal='%.4f'/>"
             "<working-plane height='%.4f'/></room>",
             side, side, ceiling, room->surfaces[opening->face].front, opening->width_m,
             opening->height_m, opening->reveal_m, ceiling - 0.001);
    struct pp_outside_light light;
    struct pp_world *world = world_of(&light, xml);
    struct pp_reading all[PP_COMPONENT_COUNT];
    trace(all, world, &light);
    double passed = 0.0;
    enum { STEPS = 2000 };
    for (int i = 0; i < STEPS; i++) {
        double cosine = (i + 0.5) / STEPS;
        passed +=
            pp_sky_luminance(&light.sky, pp_vec(sqrt(1 - cosine * cosine), 0, cosine))
            * pp_glass_transmittance(&opening->glass, cosine) * cosine * 2.0 * PP_PI
            / STEPS;
    }
    double per_N = opening->inner.area_m2 * passed / (side * side);
    *error = all[PP_DF].std_error / per_N;
    pp_world_destroy(world);
    return all[PP_DF].value / per_N;
}

/* ---- the table ---- */

struct results {
    int rooms;
    double key[MOST_ROOMS], method[MOST_METHODS][MOST_ROOMS],
        traced[MOST_METHODS][MOST_ROOMS];
};

/* Prints the number of rooms in a class, the mean and RMS deviation, and the deviation
 * of the sums. */
static void print_class(const struct results *all, int method, double low, double high)
{
    double sum = 0.0, squares = 0.0, hand = 0.0, truth = 0.0;
    int count = 0;
    for (int i = 0; i < all->rooms; i++) {
        double value = all->method[method][i], traced = all->traced[method][i];
        if (!(all->key[i] >= low && all->key[i] < high) || isnan(value))
            continue;
        double off = 100.0 * (value / traced - 1.0);
        sum += off, squares += off * off, hand += value, truth += traced;
        count++;
    }
    if (count == 0)
        printf(" - |");
    else
        printf(" %d: %+.1f, %.1f, %+.1f |", count, sum / count, sqrt(squares / count),
               100.0 * (hand / truth - 1.0));
}

static void print_results(const struct results *all, const struct family *family,
                          char *const names[], int count)
{
    printf("| method |");
    for (int c = 0; c == 0 || isfinite(family->classes[c - 1]); c++)
        printf(" %s to %g |", family->key, family->classes[c]);
    printf(" all |\n");
    for (int m = 0; m < count; m++) {
        printf("| %s |", names[m]);
        double low = -1.0;
        for (int c = 0; c == 0 || isfinite(family->classes[c - 1]); c++) {
            print_class(all, m, low, family->classes[c]);
            low = family->classes[c];
        }
        print_class(all, m, -1.0, INFINITY);
        printf("\n");
    }
}

/* Prints the well efficiency N of square wells under clear single glass and the
 * overcast sky. */
static void print_N(void)
{
    static const double indices[] = {0.125, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0};
    static const double sides[] = {0.3, 0.5, 0.7, 0.9};
    struct pp_glass glass = pp_glass_clear_single();
    const struct pp_sky sky = pp_sky_overcast();
    for (size_t i = 0; i < sizeof indices / sizeof *indices; i++) {
        struct pp_well_efficiency N = {0};
        printf("| %g |", indices[i]);
        for (int k = 0; k < 4; k++) {
            const struct pp_well_shape shape = {1.0, 1.0, indices[i], sides[k]};
            N = pp_well_efficiency(&shape, sky.gradation, &glass);
            printf(" %.2f |", N.whole);
        }
        printf(" %.2f |\n", N.direct);
    }
}

static void run(const struct family *family, int rooms)
{
    static struct results all;
    char list[512], *names[MOST_METHODS], itself[] = "N of the well itself";
    snprintf(list, sizeof list, "%s", family->methods);
    int count = split_names(list, names);
    all.rooms = rooms;
    printf("%s: %d rooms; number: bias, rms, bias of the sums, per cent\n",
           family->what, rooms);
    for (int i = 0; i < rooms; i++) {
        char xml[TEXT];
        uint64_t series = pp_hash(141421, (uint64_t)i);
        all.key[i] = family->write(xml, &series);
        struct pp_outside_light light;
        struct pp_world *world = world_of(&light, xml);
        struct pp_reading traced[PP_COMPONENT_COUNT];
        double values[MOST_METHODS];
        trace(traced, world, &light);
        evaluate(values, names, count, world, &light);
        for (int m = 0; m < count; m++) {
            bool whole = strncmp(names[m], "df ", 3) == 0;
            all.method[m][i] = values[m];
            all.traced[m][i] = traced[whole ? PP_DF : PP_IRC].value;
        }
        if (family->wells) {
            double error;
            all.traced[count][i] = traced_N(world, &error);
            all.method[count][i] = pp_well_of(world, &light, world->openings).whole;
        }
        pp_world_destroy(world);
    }
    names[count] = itself;
    if (family->wells)
        print_N();
    print_results(&all, family, names, count + family->wells);
}

int main(int argc, char **argv)
{
    int rooms = argc > 2 ? atoi(argv[2]) : 200;
    for (size_t f = 0; f < sizeof families / sizeof *families; f++)
        if (argc < 2 || strcmp(argv[1], families[f].name) == 0)
            run(&families[f], rooms < MOST_ROOMS ? rooms : MOST_ROOMS);
    return 0;
}
