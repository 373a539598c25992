/* bench_radiosity.c - the radiosity engine at each level of refinement, in the deep
 * office, in a room in a street and in a room with a partition.
 *
 * Each line gives the numbers of elements, outside cells and terms, the time up to this
 * level, and the RMS deviation from an accurate simulation. From the second level, the
 * engine's own error estimate follows. The first line for each room gives the time that
 * the path tracer needs for an error of 1 %.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/bench.h"
#include "simulate/research/radiosity/radiosity.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/fast/tracer.h"

enum { MOST_POINTS = 400, LEVELS = 3 };

/* Daylight factors from the path tracer; returns the processor time. */
static double trace(const struct pp_world *world, const struct pp_outside_light *light,
                    int points, double error, double *df)
{
    const struct pp_tracer_options options = {.error = error, .seed = 1, .threads = 1};
    struct pp_light_scene *scene;
    struct pp_environment *environment;
    struct pp_tracer *tracer;
    struct pp_error err;
    double start = processor_s();
    must(pp_light_scene_of_world_matt(&scene, world, &err), &err);
    must(pp_light_scene_under(&environment, scene, light, &err), &err);
    must(pp_tracer_create(&tracer, scene, environment, world->receivers, points,
                          &options, &err),
         &err);
    while (!pp_tracer_done(tracer))
        must(pp_tracer_advance(tracer, 10.0, &err), &err);
    double taken = processor_s() - start;
    for (int i = 0; i < points; i++) {
        struct pp_reading of[PP_COMPONENT_COUNT];
        pp_tracer_read(tracer, i, of);
        df[i] = of[PP_DF].value;
    }
    pp_tracer_destroy(tracer);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    return taken;
}

/* RMS relative deviation from the reference, and RMS of the stated relative error. Both
 * are relative to at least 0.2 %, since a point may be inside the partition. */
static void compare(const struct pp_radiosity *elements, int points,
                    const double *truth, double *off, double *stated)
{
    double sum[2] = {0.0};
    for (int i = 0; i < points; i++) {
        struct pp_reading of[PP_COMPONENT_COUNT];
        pp_radiosity_read(elements, i, of);
        double least = fmax(truth[i], 0.002);
        double distance = (of[PP_DF].value - truth[i]) / least;
        double error = of[PP_DF].std_error / least;
        sum[0] += distance * distance / points;
        sum[1] += error * error / points;
    }
    *off = sqrt(sum[0]);
    *stated = sqrt(sum[1]);
}

static void bench_room(const char *name, const char *inside)
{
    static double coarse[MOST_POINTS], truth[MOST_POINTS];
    char xml[4096];
    struct pp_outside_light light;
    snprintf(xml, sizeof xml, "<room version='1'>%s</room>", inside);
    struct pp_world *world = world_of(&light, xml);
    int points =
        world->receiver_count < MOST_POINTS ? world->receiver_count : (int)MOST_POINTS;
    const struct pp_radiosity_options options = {.error = 1e-9, .threads = 1};
    struct pp_radiosity *elements;
    struct pp_error err;
    double path_s = trace(world, &light, points, 0.01, coarse), taken = 0.0;
    trace(world, &light, points, 0.002, truth);
    printf("%s, %d points; the path tracer to 1 %%: %.3f s\n", name, points, path_s);
    must(pp_radiosity_create(&elements, world, &light, world->receivers, points,
                             &options, &err),
         &err);
    for (int level = 0; level < LEVELS; level++) {
        double start = processor_s(), off, stated;
        must(pp_radiosity_advance(elements, &err), &err);
        taken += processor_s() - start;
        struct pp_radiosity_size size = pp_radiosity_size(elements);
        compare(elements, points, truth, &off, &stated);
        printf(
            "  level %d: %5d elements, %5d cells outside, %8lld terms; %.2f s in all, "
            "%.1f times that of the tracer; deviation %.2f %%",
            level + 1, size.elements, size.cells, size.terms, taken, taken / path_s,
            100.0 * off);
        if (level > 0)
            printf(", estimated %.2f %%", 100.0 * stated);
        printf("\n");
    }
    pp_radiosity_destroy(elements);
    pp_world_destroy(world);
}

int main(void)
{
    bench_room("deep office",
               "<plan width='3' depth='9' height='2.7'/>"
               "<window wall='south' left='0.2' sill='0.8' width='2.6' height='1.5'/>"
               "<grid spacing='0.25' margin='0.1'/>");
    bench_room("street",
               "<site ground-level='-0.5'/><plan width='4' depth='5' height='2.7'/>"
               "<window wall='south' left='1' sill='0.8' width='2' height='1.5'/>"
               "<facade wall='south' left='20' right='20' up='12'/>"
               "<block x='-40' y='-22' width='84' depth='12' height='18'/>"
               "<grid spacing='0.5' margin='0.5'/>");
    bench_room("partition",
               "<plan width='4' depth='6' height='2.7'/>"
               "<window wall='south' left='0.5' sill='0.8' width='3' height='1.5'/>"
               "<partition from='0 2.5' to='2.4 2.5' height='2.2'/>"
               "<grid spacing='0.5' margin='0.3'/>");
    return 0;
}
