/* bench_light.c - effect of direct sampling (next-event estimation): values and
 * relative errors with and without it.
 *
 * The first table compares a lamp sampled directly (light) with the same lamp found by
 * chance (glow). The other tables show daylight factors at the distance y (m) from a
 * window, each with its relative error and time. The window is sampled directly, with
 * stored or with traced outside luminances, or is found by chance. The gain is the
 * ratio of the times for equal error, by chance over stored.
 */
#include <math.h>
#include <stdio.h>

#include "bench/bench.h"
#include "simulate/sampling/hash.h"
#include "simulate/scene/environment.h"
#include "simulate/scene/light_scene_of_description.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/transport/opening_store.h"
#include "simulate/transport/radiance.h"

enum { SEEDS = 32 };

/* Mean irradiance, relative error of one sequence of `paths` paths, and rays and time
 * of that sequence. */
struct outcome {
    double value, error, rays, seconds;
};

static struct outcome measure(const struct pp_light_scene *scene,
                              const struct pp_environment *environment,
                              const struct pp_opening_store *store,
                              struct pp_radiance_options options, struct pp_vec3 point,
                              uint32_t paths)
{
    static struct pp_sobol sobol;
    pp_sobol_init(&sobol);
    enum pp_space space = pp_light_scene_space(scene, point);
    double sum = 0.0, squares = 0.0, start = processor_s();
    struct outcome outcome = {.rays = 0.0};
    for (uint64_t seed = 0; seed < SEEDS; seed++) {
        struct pp_radiance_state path_state = {.scene = scene,
                                               .environment = environment,
                                               .store = store,
                                               .options = options};
        pp_sobol_sequence_init(&path_state.sequence, &sobol, pp_hash(seed, 3));
        double value = 0.0;
        for (path_state.index = 0; path_state.index < paths; path_state.index++) {
            struct pp_irradiance e = pp_radiance_irradiance(
                &path_state, point, pp_vec(0.0, 0.0, 1.0), space);
            value += (e.sources.g + e.sky.g + e.outside.g + e.rest.g) / paths;
        }
        sum += value;
        squares += value * value;
        outcome.rays += (double)path_state.rays / SEEDS;
    }
    outcome.seconds = (processor_s() - start) / SEEDS;
    outcome.value = sum / SEEDS;
    outcome.error = sqrt(fmax(0.0, squares / SEEDS - outcome.value * outcome.value))
                    / outcome.value;
    return outcome;
}

/* ---- light and glow ---- */

static struct pp_light_scene *lamp(struct pp_material material)
{
    const double a = 0.35, h = 2.3;
    const struct pp_vec3 corners[] = {{-a, -a, h}, {-a, a, h}, {a, a, h}, {a, -a, h}};
    struct pp_scene_description from;
    struct pp_light_scene *scene;
    struct pp_error err;
    int index;
    pp_scene_description_init(&from);
    must(pp_scene_description_add_material(&from, &material, &index, &err), &err);
    must(pp_scene_description_add_polygon(&from, corners, 4, index, NULL, &err), &err);
    must(pp_light_scene_of_description(&scene, &from, &err), &err);
    pp_scene_description_clear(&from);
    return scene;
}

static void light_and_glow(void)
{
    struct pp_radiance_options options = pp_radiance_state_defaults();
    options.source_size = 0.0;
    struct pp_vec3 under = {0.0, 0.0, 0.0};
    struct pp_light_scene *light = lamp(pp_material_light(pp_rgb_grey(1.0)));
    struct pp_light_scene *glow = lamp(pp_material_glow(pp_rgb_grey(1.0)));
    double s = hypot(0.35, 2.3);
    double exact = 4.0 * (0.35 / s) * atan(0.35 / s);
    printf("a square lamp of 0.7 m, 2.3 m above a plane: closed form %.6f\n", exact);
    printf("  %8s  %12s %9s  %12s %9s\n", "rays", "as light", "error", "as glow",
           "error");
    for (uint32_t paths = 4; paths <= 65536; paths *= 4) {
        /* With next-event estimation a path has two rays: one to the lamp, and one in a
         * sampled direction. */
        struct outcome a = measure(light, NULL, NULL, options, under, paths / 2);
        struct outcome b = measure(glow, NULL, NULL, options, under, paths);
        printf("  %8.0f  %12.6f %8.4f%%  %12.6f %8.4f%%\n", b.rays, a.value,
               100.0 * a.error, b.value, 100.0 * b.error);
    }
    struct outcome few = measure(light, NULL, NULL, options, under, 32);
    struct outcome many = measure(glow, NULL, NULL, options, under, 65536);
    printf("  light, %.0f rays: error %.4f %%; glow, %.0f rays: error %.4f %%; "
           "ratios: rays %.2f %%, error %.2f\n",
           few.rays, 100.0 * few.error, many.rays, 100.0 * many.error,
           100.0 * few.rays / many.rays, few.error / many.error);
    pp_light_scene_destroy(light);
    pp_light_scene_destroy(glow);
}

/* ---- openings ---- */

/* Cost for equal error is proportional to time x error^2. */
static double cost(const struct outcome *outcome)
{
    return outcome->seconds * outcome->error * outcome->error;
}

static void openings(const char *name, const char *xml)
{
    struct pp_outside_light light;
    struct pp_world *world = world_of(&light, xml);
    struct pp_light_scene *scene;
    struct pp_environment *environment;
    struct pp_opening_store *store;
    struct pp_error err;
    must(pp_light_scene_of_world(&scene, world, &err), &err);
    must(pp_light_scene_under(&environment, scene, &light, &err), &err);
    double start = processor_s(), log_sum = 0.0;
    must(pp_opening_store_create(&store, scene, environment, 1, 1, &err), &err);
    printf("%s (store: %.3f s)\n", name, processor_s() - start);
    printf("  %5s  %-19s %-19s %-19s  gain\n", "y", "sampled, stored",
           "sampled, traced", "found by chance");
    struct pp_radiance_options options = pp_radiance_state_defaults();
    options.source_size = 0.5;
    for (int i = 0; i < world->receiver_count; i++) {
        struct pp_vec3 p = world->receivers[i].position;
        options.windows = true;
        struct outcome stored = measure(scene, environment, store, options, p, 1024);
        struct outcome sampled = measure(scene, environment, NULL, options, p, 1024);
        options.windows = false;
        struct outcome found = measure(scene, environment, NULL, options, p, 4096);
        printf("  %5.2f  %6.3f%% %5.2f%% %4.1fms %6.3f%% %5.2f%% %4.1fms %6.3f%% "
               "%5.2f%% %4.1fms %5.1f times\n",
               p.y, 100.0 * stored.value, 100.0 * stored.error, 1e3 * stored.seconds,
               100.0 * sampled.value, 100.0 * sampled.error, 1e3 * sampled.seconds,
               100.0 * found.value, 100.0 * found.error, 1e3 * found.seconds,
               cost(&found) / cost(&stored));
        log_sum += log(cost(&found) / cost(&stored));
    }
    printf(
        "  the time for equal error is reduced by a factor of %.1f (geometric mean)\n",
        exp(log_sum / world->receiver_count));
    pp_opening_store_destroy(store);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

#define DEEP                                                                           \
    "<room version='1'><plan width='3' depth='9' height='2.7'/>"                       \
    "<finishes floor='0.2' walls='0.7' ceiling='0.8'/>"                                \
    "<window wall='south' left='0.2' sill='0.8' width='2.6' height='1.5' "             \
    "glazing='clear-single'/><line from='1.5 0.5' to='1.5 8.5' points='9'/>"

int main(void)
{
    light_and_glow();
    openings("deep room, 3 x 9 x 2.7 m: daylight factor, error, time", DEEP "</room>");
    openings("the same with a house opposite",
             DEEP "<block x='-4' y='-14' width='10' depth='6' height='8'/></room>");
    openings("the same with a small window",
             "<room version='1'><plan width='3' depth='9' height='2.7'/>"
             "<finishes floor='0.2' walls='0.7' ceiling='0.8'/>"
             "<window wall='south' left='1' sill='1' width='0.8' height='0.8'/>"
             "<line from='1.5 0.5' to='1.5 8.5' points='5'/></room>");
    return 0;
}
