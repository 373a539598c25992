/* bench_rooms.c - time for the simulation of up to a thousand random rooms, and of one
 * room with different numbers of points, windows, polygons and threads. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/bench.h"
#include "model/base/clock.h"
#include "model/base/thread_pool.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/fast/tracer.h"
#include "tests/lib/random_rooms.h"

struct times {
    double clock_s, processor_s;
};

/* Traces the daylight factors of all receivers to 1 %, and adds the times, including
 * the scene. */
static void trace(struct times *sum, const struct pp_world *world,
                  const struct pp_outside_light *light, int threads, bool average)
{
    struct pp_tracer_options options = {
        .error = 0.01, .seed = 1, .threads = threads, .average = average};
    struct pp_light_scene *scene;
    struct pp_environment *environment;
    struct pp_tracer *tracer;
    struct pp_error err;
    double start = pp_clock_s(), spent = processor_s();
    must(pp_light_scene_of_world_matt(&scene, world, &err), &err);
    must(pp_light_scene_under(&environment, scene, light, &err), &err);
    must(pp_tracer_create(&tracer, scene, environment, world->receivers,
                          world->receiver_count, &options, &err),
         &err);
    while (!pp_tracer_done(tracer))
        must(pp_tracer_advance(tracer, 10.0, &err), &err);
    pp_tracer_destroy(tracer);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    sum->clock_s += pp_clock_s() - start;
    sum->processor_s += processor_s() - spent;
}

/* Rooms one after another, with two threads each. */
static void bench_rooms(void)
{
    enum { POINTS = 8, THREADS = 2, ROOMS = 1000 };
    struct times sum = {0.0, 0.0};
    printf("random rooms (tests/lib/random_rooms.h), %d points at 1 %%, %d "
           "threads:\n",
           (int)POINTS, (int)THREADS);
    for (int i = 0, told = 10; i < ROOMS; i++) {
        struct pp_outside_light light;
        struct pp_world *world = pp_test_random_room(&light, (uint64_t)i, POINTS);
        trace(&sum, world, &light, THREADS, false);
        pp_world_destroy(world);
        if (i + 1 == told) {
            printf("  %d: %.2f s, %.2f s of processor time%s\n", told, sum.clock_s,
                   sum.processor_s, told == ROOMS ? " (target: 20 s)" : "");
            fflush(stdout);
            told *= 10;
        }
    }
}

/* Best time of three runs. */
static double trace_xml(const char *xml, int threads, bool by_clock)
{
    double best = INFINITY;
    struct pp_outside_light light;
    struct pp_world *world = world_of(&light, xml);
    for (int i = 0; i < 3; i++) {
        struct times sum = {0.0, 0.0};
        trace(&sum, world, &light, threads, true);
        best = fmin(best, by_clock ? sum.clock_s : sum.processor_s);
    }
    pp_world_destroy(world);
    return best;
}

/* ---- one room that grows ---- */

enum { TEXT = 1 << 22 };

/* A room of 24 x 8 x 3 m with `windows` windows in its long wall, `screens`
 * quadrilaterals in front of it, and `columns` x 8 points. */
static char *grown_room(int columns, int windows, int screens)
{
    char *xml = malloc(TEXT);
    if (!xml)
        exit(3);
    int n = snprintf(xml, TEXT,
                     "<room version='1'><plan width='24' depth='8' height='3'/>"
                     "<finishes floor='0.2' walls='0.5' ceiling='0.7'/>");
    for (int i = 0; i < windows; i++)
        n += snprintf(xml + n, (size_t)(TEXT - n),
                      "<window wall='south' left='%.4f' sill='0.9' width='%.4f' "
                      "height='1.5' glazing='clear-single'/>",
                      24.0 * (i + 0.1) / windows, 24.0 * 0.8 / windows);
    for (int i = 0; i < screens; i++) {
        double x = 24.0 * i / screens, z = 4.0 + 0.01 * (i % 7), wide = 12.0 / screens;
        n += snprintf(xml + n, (size_t)(TEXT - n),
                      "<surface reflectance='0.3'>"
                      "<vertex x='%.4f' y='-6' z='%.3f'/>"
                      "<vertex x='%.4f' y='-6' z='%.3f'/>"
                      "<vertex x='%.4f' y='-6' z='0.1'/>"
                      "<vertex x='%.4f' y='-6' z='0.1'/></surface>",
                      x, z, x + wide, z, x + wide, x);
    }
    for (int i = 0; i < columns * 8; i++)
        n += snprintf(xml + n, (size_t)(TEXT - n), "<point x='%.4f' y='%.4f'/>",
                      24.0 * (i / 8 + 0.5) / columns, i % 8 + 0.5);
    snprintf(xml + n, (size_t)(TEXT - n), "</room>");
    return xml;
}

static void print_growth(const char *of, const int *counts, const double *seconds,
                         int count)
{
    printf("%s:", of);
    for (int i = 0; i < count; i++)
        printf(" %d: %.3g s%s", counts[i], seconds[i], i + 1 < count ? "," : "\n");
}

static void bench_growth(void)
{
    static const int points[] = {8, 32, 128, 512}, windows[] = {1, 4, 16},
                     screens[] = {10, 100, 1000, 10000};
    double seconds[4];
    puts(
        "one room, 24 x 8 x 3 m, at 1 % with the average, one thread, processor time:");
    for (int i = 0; i < 4; i++) {
        char *xml = grown_room(points[i] / 8, 4, 0);
        seconds[i] = trace_xml(xml, 1, false);
        free(xml);
    }
    print_growth("  points", points, seconds, 4);
    for (int i = 0; i < 3; i++) {
        char *xml = grown_room(4, windows[i], 0);
        seconds[i] = trace_xml(xml, 1, false);
        free(xml);
    }
    print_growth("  windows", windows, seconds, 3);
    for (int i = 0; i < 4; i++) {
        char *xml = grown_room(4, 4, screens[i]);
        seconds[i] = trace_xml(xml, 1, false);
        free(xml);
    }
    print_growth("  polygons outside", screens, seconds, 4);
}

enum { ROUNDS = 8, PROCESSORS_MOST = 64 };

static void bench_threads(void)
{
    struct pp_thread_pool *pool;
    struct pp_error err;
    must(pp_thread_pool_create(&pool, 0, &err), &err);
    int most = pp_thread_pool_size(pool);
    pp_thread_pool_destroy(pool);
    char *xml = grown_room(64, 4, 0);
    double best[2 * PROCESSORS_MOST + 1];
    int end = 2 * (most < PROCESSORS_MOST ? most : PROCESSORS_MOST);
    for (int round = 0; round < ROUNDS; round++) /* repeated, since the speed of a
                                                  * machine varies */
        for (int threads = 1; threads <= end; threads *= 2) {
            double taken = trace_xml(xml, threads, true);
            best[threads] = round > 0 ? fmin(best[threads], taken) : taken;
        }
    printf("clock time by number of threads, 512 points: 1: %.3g s", best[1]);
    for (int threads = 2; threads <= end; threads *= 2)
        printf(", %d: %.3g s (%.2f times as fast)", threads, best[threads],
               best[1] / best[threads]);
    printf("; %d processor%s\n", most, most > 1 ? "s" : "");
    free(xml);
}

int main(void)
{
    bench_rooms();
    bench_growth();
    bench_threads();
    return 0;
}
