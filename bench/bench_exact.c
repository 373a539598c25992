/* bench_exact.c - speed of the direct component by `exact` on one core, in several
 * scenes. Each scene has three rows: without tables, with tables for any point
 * (prepared), and with tables for one plane, accurate to 1e-6. Each row gives the time
 * for one point and the time for preparing the tables. */
#include <stdio.h>

#include "bench/bench.h"
#include "methods/method.h"
#include "methods/exact/solid_angle.h"

/* Speed of the closed form alone: a window without obstructions, at points along a
 * line. */
static void closed_form(void)
{
    enum { POINTS = 4000000 };
    const struct pp_vec3 zenith = {0.0, 0.0, 1.0};
    struct pp_sky sky = pp_sky_overcast();
    double sum = 0.0, start = processor_s();
    for (int i = 0; i < POINTS; i++) {
        double y = 0.5 + 8.0 * i / POINTS;
        const struct pp_vec3 window[4] = {
            {-0.9, y, 0.1}, {1.7, y, 0.1}, {1.7, y, 1.5}, {-0.9, y, 1.5}};
        struct pp_moments moments = {0};
        pp_solid_angle_add_moments(&moments, window, 4, zenith, &zenith, 1);
        sum += pp_solid_angle_sky_component(&moments, &sky);
    }
    double seconds = processor_s() - start;
    printf(
        "closed form, overcast           %8.2f million window-points/s (mean %.6f)\n",
        POINTS / seconds / 1e6, sum / POINTS);
}

/* A variant of the method: a function that prepares tables (may be NULL), and a
 * function that evaluates a point. */
struct way {
    const char *name;
    enum pp_status (*prepare)(void **tools, const struct pp_world *world,
                              const struct pp_outside_light *light,
                              struct pp_error *err);
    enum pp_status (*evaluate)(const struct pp_world *world,
                               const struct pp_outside_light *light,
                               const struct pp_opening *opening,
                               const struct pp_receiver *receiver, const void *tools,
                               struct pp_part *part, struct pp_error *err);
};

/* Time per point (us) over a grid of points, measured for about half a second. */
static double point_us(const struct pp_world *world,
                       const struct pp_outside_light *light, const struct way *way,
                       const void *tools, double *mean)
{
    enum { COLUMNS = 24, ROWS = 72 };
    long points = 0;
    double sum = 0.0, start = processor_s(), seconds;
    do {
        for (int i = 0; i < COLUMNS * ROWS; i++) {
            struct pp_receiver receiver = {{3.0 * (i % COLUMNS + 0.5) / COLUMNS,
                                            9.0 * (i / COLUMNS + 0.5) / ROWS, 0.85},
                                           {0.0, 0.0, 1.0},
                                           0,
                                           0.0};
            struct pp_part part = {0};
            if (way->evaluate(world, light, &world->openings[0], &receiver, tools,
                              &part, NULL)
                != PP_OK)
                continue;
            sum += part.sky + part.external;
            points++;
        }
        seconds = processor_s() - start;
    } while (seconds < 0.5);
    *mean = sum / (double)points;
    return 1e6 * seconds / (double)points;
}

/* Prints the times of each variant of the method: for its tables, and for one point. */
static void rooms(const char *name, const char *parts)
{
    const struct way ways[] = {
        {"not prepared", NULL, pp_method_exact.evaluate},
        {"prepared", pp_method_exact.prepare_fast, pp_method_exact.evaluate},
        {"for a plane, to 1e-6", pp_method_exact.prepare_for_plane,
         pp_method_exact.evaluate_roughly}};
    char xml[4096];
    snprintf(xml, sizeof xml,
             "<room version='1'><plan width='3.0' depth='9.0' height='2.7'/>%s</room>",
             parts);
    struct pp_outside_light light;
    struct pp_world *world = world_of(&light, xml);
    if (!world) {
        printf("%s: no world\n", name);
        return;
    }
    printf("%s\n", name);
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        struct pp_error err = {.message = ""};
        void *tools = NULL;
        double start = processor_s(), made_us, mean;
        if (ways[i].prepare)
            must(ways[i].prepare(&tools, world, &light, &err), &err);
        made_us = 1e6 * (processor_s() - start);
        double us = point_us(world, &light, &ways[i], tools, &mean);
        printf("  %-22s %9.3f us per point (mean %.9f); tables %6.0f us\n",
               ways[i].name, us, mean, made_us);
        pp_method_exact.destroy_tools(tools);
    }
    pp_world_destroy(world);
}

#define WINDOW(glazing)                                                                \
    "<window wall='south' left='0.2' sill='0.8' width='2.6' height='1.5' "             \
    "glazing='" glazing "'/>"
#define BLOCK "<block x='-4' y='-14' width='10' depth='6' height='8'/>"
#define SKYLINE "<skyline wall='south' angle='20'/>"
#define SUN(type) "<sky type='" type "' sun-altitude='40' sun-bearing='160'/>"

int main(void)
{
    closed_form();
    rooms("unglazed", WINDOW("none"));
    rooms("unglazed, skyline", WINDOW("none") SKYLINE);
    rooms("unglazed, block", WINDOW("none") BLOCK);
    rooms("unglazed, 5 blocks", WINDOW("none") BLOCK
          "<block x='-9' y='-10' width='3' depth='6' height='5'/>"
          "<block x='7' y='-12' width='5' depth='5' height='9' rotate='20'/>"
          "<block x='0' y='-30' width='5' depth='5' height='25'/>"
          "<block x='-14' y='-20' width='4' depth='5' height='12' rotate='50'/>");
    rooms("clear glass", WINDOW("clear-single"));
    rooms("clear glass, skyline", WINDOW("clear-single") SKYLINE);
    rooms("clear glass, block", WINDOW("clear-single") BLOCK);
    rooms("iso-5, unglazed", "<sky type='iso-5'/>" WINDOW("none"));
    rooms("iso-1, unglazed", "<sky type='iso-1'/>" WINDOW("none"));
    rooms("iso-12, clear glass", SUN("iso-12") WINDOW("clear-single"));
    rooms("iso-12, clear glass, block", SUN("iso-12") WINDOW("clear-single") BLOCK);
    rooms("iso-12, unglazed", SUN("iso-12") WINDOW("none"));
    rooms("iso-15, double glazing", SUN("iso-15") WINDOW("clear-double"));
    return 0;
}
