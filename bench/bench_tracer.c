/* bench_tracer.c - time of the fast path tracer for whole rooms, and time per traced
 * ray compared with that of the ray kernels alone.
 *
 * Leaks are rays that slip through a gap between two surfaces.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/bench.h"
#include "simulate/sampling/hash.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/scene/light_scene_parts.h"
#include "simulate/fast/control_variate_solve.h"
#include "simulate/fast/path.h"
#include "simulate/fast/tracer.h"
#include "tests/lib/random_rooms.h"

/* Traces all receivers and the average over the working plane. Writes the daylight
 * factors of the receivers, without the average, to df; returns the time (s). */
static double trace(const struct pp_world *world, const struct pp_outside_light *light,
                    double error, int threads, uint64_t seed, struct pp_reading *df,
                    struct pp_tracer_work *work)
{
    struct pp_tracer_options options = {
        .error = error, .seed = seed, .threads = threads, .average = true};
    struct pp_light_scene *scene;
    struct pp_environment *environment;
    struct pp_tracer *tracer;
    struct pp_error err;
    double start = processor_s();
    must(pp_light_scene_of_world_matt(&scene, world, &err), &err);
    must(pp_light_scene_under(&environment, scene, light, &err), &err);
    must(pp_tracer_create(&tracer, scene, environment, world->receivers,
                          world->receiver_count, &options, &err),
         &err);
    while (!pp_tracer_done(tracer))
        must(pp_tracer_advance(tracer, 10.0, &err), &err);
    double taken = processor_s() - start;
    for (int i = 0; i < world->receiver_count; i++) {
        struct pp_reading readings[PP_COMPONENT_COUNT];
        pp_tracer_read(tracer, i, readings);
        df[i] = readings[PP_DF];
    }
    *work = pp_tracer_work(tracer);
    pp_tracer_destroy(tracer);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    return taken;
}

/* Mean time over several seeds for a target error, and deviation of the values. */
static void bench_error(const char *name, const struct pp_world *world,
                        const struct pp_outside_light *light,
                        const struct pp_reading *fine, double error, int runs)
{
    int count = world->receiver_count;
    struct pp_reading *quick = calloc((size_t)count, sizeof *quick);
    if (!quick)
        exit(3);
    struct pp_tracer_work work;
    double squares = 0.0, z_squares = 0.0, worst = 0.0, taken = 0.0;
    for (int seed = 0; seed < runs; seed++) {
        taken += trace(world, light, error, 1, (uint64_t)seed, quick, &work);
        for (int i = 0; i < count; i++) {
            double off = quick[i].value / fine[i].value - 1.0;
            double z = (quick[i].value - fine[i].value)
                       / hypot(quick[i].std_error, fine[i].std_error);
            squares += off * off;
            z_squares += z * z;
            worst = fmax(worst, fabs(off));
        }
    }
    printf("%s: %d points and the average at %.1f %%: %.3f s of one core (mean of "
           "%d)\n",
           name, count, 100.0 * error, taken / runs, runs);
    printf("  RMS error %.2f %%, worst %.2f %%, %.2f standard errors, compared with a "
           "more accurate run\n",
           100.0 * sqrt(squares / (runs * count)), 100.0 * worst,
           sqrt(z_squares / (runs * count)));
    printf("  %.2f million paths, %.2f million rays, %lld leaks\n", 1e-6 * work.paths,
           1e-6 * work.rays, work.leaks);
    free(quick);
}

static void bench_room(const char *name, const char *xml)
{
    static const struct {
        double error;
        int runs;
    } wanted[] = {{0.01, 20}, {0.004, 8}, {0.002, 4}};
    struct pp_outside_light light;
    struct pp_world *world = world_of(&light, xml);
    struct pp_reading *fine = calloc((size_t)world->receiver_count, sizeof *fine);
    if (!fine)
        exit(3);
    struct pp_tracer_work work;
    trace(world, &light, 0.0007, 0, 77, fine, &work);
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++)
        bench_error(name, world, &light, fine, wanted[i].error, wanted[i].runs);
    free(fine);
    pp_world_destroy(world);
}

/* Random rooms of the tests, eight points each, to 1 %. */
static void bench_random_rooms(void)
{
    enum { ROOMS = 40, POINTS = 8 };
    double taken = 0.0;
    for (uint64_t number = 0; number < ROOMS; number++) {
        struct pp_outside_light light;
        struct pp_reading df[POINTS];
        struct pp_tracer_work work;
        struct pp_world *world = pp_test_random_room(&light, number, POINTS);
        taken += trace(world, &light, 0.01, 1, number, df, &work);
        pp_world_destroy(world);
    }
    printf(
        "random rooms: %d points and the average at 1 %%: %.1f ms of one core per room "
        "(mean of %d)\n",
        (int)POINTS, 1e3 * taken / ROOMS, (int)ROOMS);
}

/* ---- rays compared with the bare ray kernels ---- */

/* Traces 32 randomisations of `paths` paths of each kind (a quarter of them for the
 * correction) for all receivers; rays are logged if there is a log. */
static void run_randomisations(const struct pp_world *world,
                               const struct pp_light_scene *scene,
                               const struct pp_environment *environment,
                               const struct pp_control_variate *variate,
                               const struct pp_sobol *sobol, uint32_t paths,
                               bool every_ray, struct pp_path_state *path_state,
                               struct pp_ray_log *log)
{
    *path_state = pp_path_state(scene, environment, variate);
    path_state->light.every_ray = every_ray;
    path_state->light.log = log;
    for (int i = 0; i < world->receiver_count; i++)
        for (uint64_t k = 0; k < 32; k++) {
            struct pp_start start = {
                .position = pp_vec_sub(world->receivers[i].position, scene->centre),
                .normal = world->receivers[i].normal};
            struct pp_light light = {{0.0, 0.0, 0.0}};
            double gathered = 0.0;
            uint32_t *index = &path_state->light.index;
            for (int estimator = 0; estimator < 3; estimator++) {
                uint32_t end = estimator == 2 ? paths / 4 : paths;
                pp_sobol_sequence_init(
                    &path_state->light.sequence, sobol,
                    pp_hash(pp_hash(k, (uint64_t)i), (uint64_t)estimator));
                *index = 0;
                if (estimator == 1)
                    pp_path_gather(path_state, &start, end, &gathered);
                else if (estimator == 2)
                    pp_path_correction(path_state, &start, end, &gathered);
                else
                    pp_path_direct(path_state, &start, end, &light);
            }
        }
}

static void bench_rays(const char *name, const struct pp_world *world,
                       const struct pp_outside_light *light, uint32_t paths,
                       bool every_ray)
{
    struct pp_error err;
    struct pp_light_scene *scene;
    struct pp_environment *environment;
    struct pp_control_variate *variate;
    static struct pp_sobol sobol;
    pp_sobol_init(&sobol);
    must(pp_light_scene_of_world_matt(&scene, world, &err), &err);
    must(pp_light_scene_under(&environment, scene, light, &err), &err);
    must(pp_control_variate_solve(&variate, scene, environment, &sobol, 1, 1, &err),
         &err);
    struct pp_path_state path_state;
    run_randomisations(world, scene, environment, variate, &sobol, paths, every_ray,
                       &path_state, NULL);
    struct pp_ray_log log = {NULL, 0, path_state.light.rays};
    log.rays = malloc(sizeof *log.rays * (size_t)path_state.light.rays);
    float(*bare)[6] = malloc(sizeof *bare * (size_t)path_state.light.rays);
    if (!log.rays || !bare)
        exit(3);
    run_randomisations(world, scene, environment, variate, &sobol, paths, every_ray,
                       &path_state, &log);
    for (long i = 0; i < log.count; i++) {
        struct pp_vec3 p = pp_vec_along(log.rays[i].from, 1e-5, log.rays[i].off);
        struct pp_vec3 u = log.rays[i].to;
        const double six[6] = {p.x, p.y, p.z, u.x, u.y, u.z};
        for (int k = 0; k < 6; k++)
            bare[i][k] = (float)six[k];
    }
    double traced = INFINITY, kernels = INFINITY, t;
    long hits = 0;
    for (int repeat = 0; repeat < 3; repeat++) {
        double start = processor_s();
        run_randomisations(world, scene, environment, variate, &sobol, paths, every_ray,
                           &path_state, NULL);
        traced = fmin(traced, processor_s() - start);
        start = processor_s();
        for (long i = 0; i < log.count; i++) {
            float distance;
            hits +=
                pp_rays_first(scene->rays, &bare[i][0], &bare[i][3], &distance) >= 0;
        }
        t = processor_s() - start;
        kernels = fmin(kernels, t);
    }
    printf("%s%s: %ld rays (%.0f %% hit), %.0f ns per traced ray, %.0f ns by the "
           "kernels alone: ratio %.2f\n",
           name, every_ray ? ", every ray" : "", log.count,
           100.0 * hits / (3.0 * log.count), 1e9 * traced / log.count,
           1e9 * kernels / log.count, kernels / traced);
    free(bare);
    free(log.rays);
    pp_control_variate_destroy(variate);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
}

/* Adds `count` small triangles inside the L-shaped room to its world. */
static void fill_with_triangles(struct pp_world *world, int count)
{
    int there = world->surface_count;
    struct pp_surface *surfaces =
        realloc(world->surfaces, sizeof *surfaces * (size_t)(there + count));
    if (!surfaces)
        exit(3);
    world->surfaces = surfaces;
    uint64_t state = 1;
    for (int i = there; i < there + count; i++) {
        double r[9];
        for (int k = 0; k < 9; k++) {
            state = pp_hash(state, 3);
            r[k] = (double)(state >> 11) * 0x1p-53;
        }
        struct pp_vec3 *v = malloc(3 * sizeof *v);
        if (!v)
            exit(3);
        v[0] = pp_vec(0.1 + 4.7 * r[0], 0.1 + 1.7 * r[1], 1.0 + 1.4 * r[2]);
        v[1] = pp_vec_along(v[0], 0.01, pp_vec(r[3], r[4], r[5]));
        v[2] = pp_vec_along(v[0], 0.01, pp_vec(r[6], -r[7], r[8]));
        struct pp_vec3 normal =
            pp_vec_cross(pp_vec_sub(v[1], v[0]), pp_vec_sub(v[2], v[0]));
        double length = pp_vec_length(normal);
        surfaces[i] = (struct pp_surface){
            .outline = {3, v, pp_vec_scale(normal, 1.0 / length), length / 2.0},
            .role = PP_FREE_SURFACE,
            .inside = true,
            .front = 0.5,
            .back = 0.5,
            .owner = -1};
    }
    world->surface_count += count;
}

#define L_SHAPED                                                                       \
    "<room version='1'><plan height='2.6'><vertex x='0' y='0'/>"                       \
    "<vertex x='5' y='0'/><vertex x='5' y='2'/><vertex x='2' y='2'/>"                  \
    "<vertex x='2' y='6'/><vertex x='0' y='6'/></plan>"                                \
    "<window wall='2' left='0.2' sill='0.9' width='1.6' height='1.4'/>"                \
    "<grid spacing='0.5'/></room>"

int main(void)
{
    bench_room("deep room, 3 x 9 x 2.7 m",
               "<room version='1'><plan width='3' depth='9' height='2.7'/>"
               "<finishes floor='0.2' walls='0.5' ceiling='0.7'/>"
               "<window wall='south' left='0.2' sill='0.8' width='2.6' height='1.5' "
               "glazing='clear-single'/>"
               "<line from='1.5 0.5' to='1.5 8.5' points='17'/></room>");
    bench_room("grid of 0.25 m, 4 x 6 x 3 m",
               "<room version='1'><plan width='4' depth='6' height='3'/>"
               "<finishes floor='0.2' walls='0.5' ceiling='0.7'/>"
               "<window wall='south' left='0.5' sill='0.9' width='3' height='1.5' "
               "glazing='none'/><grid spacing='0.25' margin='0'/></room>");
    bench_random_rooms();

    struct pp_outside_light light;
    struct pp_world *world = world_of(
        &light, "<room version='1'><plan width='4' depth='6' height='3'/>"
                "<window wall='south' left='0.5' sill='0.9' width='3' height='1.5'/>"
                "<grid spacing='1'/></room>");
    bench_rays("seven polygons, without known rays", world, &light, 64, false);
    bench_rays("seven polygons", world, &light, 64, true);
    pp_world_destroy(world);
    world = world_of(&light, L_SHAPED);
    bench_rays("nine polygons", world, &light, 64, false);
    fill_with_triangles(world, 1000000);
    bench_rays("a million polygons", world, &light, 16, false);
    pp_world_destroy(world);
    return 0;
}
