/* bench_photons.c - computing time of photon mapping divided by that of the path
 * tracer, for equal error, in several kinds of rooms.
 *
 * Each line gives the time and the error of both methods. The ratio is time times
 * squared error for photon mapping, divided by the same product for the path tracer. If
 * the ratio is above 1, the path tracer is faster. The fast path tracer treats all
 * surfaces as matt. In the room with a mirror, photons are therefore compared with the
 * general path tracer in simulate/transport.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/bench.h"
#include "simulate/research/photons/photons.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/fast/tracer.h"
#include "simulate/transport/sensors.h"

enum { RUNS = 2, MOST_POINTS = 400 };

/* A room with its light. */
struct scenario {
    const struct pp_world *world;
    struct pp_light_scene *scene;
    struct pp_environment *environment;
    int points;
    double error;
};

/* Processor time of a simulation, and its mean squared relative standard error. */
struct outcome {
    double taken_s, variance;
};

static void add(struct outcome *outcome, double value, double std_error, int points)
{
    outcome->variance += std_error / value * (std_error / value) / points;
}

static struct outcome by_photons(const struct scenario *scenario, uint64_t seed)
{
    const struct pp_photons_options options = {
        .error = scenario->error, .seed = seed, .threads = 1};
    struct outcome outcome = {processor_s(), 0.0};
    struct pp_photons *photons;
    struct pp_error err;
    must(pp_photons_create(&photons, scenario->scene, scenario->environment,
                           scenario->world->receivers, scenario->points, &options,
                           &err),
         &err);
    while (!pp_photons_done(photons))
        must(pp_photons_advance(photons, 10.0, &err), &err);
    outcome.taken_s = processor_s() - outcome.taken_s;
    for (int i = 0; i < scenario->points; i++) {
        struct pp_reading of[PP_COMPONENT_COUNT];
        pp_photons_read(photons, i, of);
        add(&outcome, of[PP_DF].value, of[PP_DF].std_error, scenario->points);
    }
    pp_photons_destroy(photons);
    return outcome;
}

static struct outcome by_paths(const struct scenario *scenario, uint64_t seed)
{
    const struct pp_tracer_options options = {
        .error = scenario->error, .seed = seed, .threads = 1};
    struct outcome outcome = {processor_s(), 0.0};
    struct pp_tracer *tracer;
    struct pp_error err;
    must(pp_tracer_create(&tracer, scenario->scene, scenario->environment,
                          scenario->world->receivers, scenario->points, &options, &err),
         &err);
    while (!pp_tracer_done(tracer))
        must(pp_tracer_advance(tracer, 10.0, &err), &err);
    outcome.taken_s = processor_s() - outcome.taken_s;
    for (int i = 0; i < scenario->points; i++) {
        struct pp_reading of[PP_COMPONENT_COUNT];
        pp_tracer_read(tracer, i, of);
        add(&outcome, of[PP_DF].value, of[PP_DF].std_error, scenario->points);
    }
    pp_tracer_destroy(tracer);
    return outcome;
}

static struct outcome by_sensors(const struct scenario *scenario, uint64_t seed)
{
    const struct pp_sensors_options options = {
        .error = scenario->error, .seed = seed, .threads = 1, .horizontal = 1.0};
    struct pp_sensor list[MOST_POINTS];
    struct outcome outcome = {processor_s(), 0.0};
    struct pp_sensors *sensors;
    struct pp_error err;
    for (int i = 0; i < scenario->points; i++)
        list[i] = (struct pp_sensor){scenario->world->receivers[i].position,
                                     scenario->world->receivers[i].normal, 0};
    must(pp_sensors_create(&sensors, scenario->scene, scenario->environment, list,
                           scenario->points, &options, &err),
         &err);
    while (!pp_sensors_done(sensors))
        must(pp_sensors_advance(sensors, 10.0, &err), &err);
    outcome.taken_s = processor_s() - outcome.taken_s;
    for (int i = 0; i < scenario->points; i++) {
        struct pp_sensor_reading of = pp_sensors_read(sensors, i);
        add(&outcome, of.grey, of.grey_error, scenario->points);
    }
    pp_sensors_destroy(sensors);
    return outcome;
}

/* Mean of time times variance over several runs. */
static double cost_of(struct outcome (*simulate)(const struct scenario *, uint64_t),
                      const struct scenario *scenario, struct outcome *mean)
{
    double cost = 0.0;
    *mean = (struct outcome){0.0, 0.0};
    for (uint64_t seed = 0; seed < RUNS; seed++) {
        struct outcome one = simulate(scenario, seed);
        cost += one.taken_s * one.variance / RUNS;
        mean->taken_s += one.taken_s / RUNS;
        mean->variance += one.variance / RUNS;
    }
    return cost;
}

static void bench_room(const char *name, const char *xml, bool gloss, double error)
{
    struct pp_outside_light light;
    struct pp_world *world = world_of(&light, xml);
    struct scenario scenario = {.world = world, .error = error};
    struct pp_error err;
    scenario.points =
        world->receiver_count < MOST_POINTS ? world->receiver_count : (int)MOST_POINTS;
    must((gloss ? pp_light_scene_of_world
                : pp_light_scene_of_world_matt)(&scenario.scene, world, &err),
         &err);
    must(pp_light_scene_under(&scenario.environment, scenario.scene, &light, &err),
         &err);
    struct outcome photons, paths;
    double ratio = cost_of(by_photons, &scenario, &photons)
                   / cost_of(gloss ? by_sensors : by_paths, &scenario, &paths);
    printf("%-26s %3d points at %.1f %%: photons %.3f s to %.2f %%, paths %.3f s to "
           "%.2f %%; ratio %.2f\n",
           name, scenario.points, 100.0 * error, photons.taken_s,
           100.0 * sqrt(photons.variance), paths.taken_s, 100.0 * sqrt(paths.variance),
           ratio);
    pp_environment_destroy(scenario.environment);
    pp_light_scene_destroy(scenario.scene);
    pp_world_destroy(world);
}

#define PLAN "<plan width='4' depth='6' height='3'/>"
#define GRID(spacing) "<grid spacing='" spacing "' margin='0.5'/>"
#define WINDOW(width, height, sill)                                                    \
    "<window wall='south' left='0.4' sill='" sill "' width='" width                    \
    "' height='" height "'/>"
#define WELL                                                                           \
    "<facade wall='south' up='6' left='4' right='4' reflectance='0.7'/>"               \
    "<block x='-4' y='-8' width='12' depth='5' height='9' reflectance='0.7'/>"         \
    "<block x='-4' y='-3' width='4' depth='3' height='9' reflectance='0.7'/>"          \
    "<block x='4' y='-3' width='4' depth='3' height='9' reflectance='0.7'/>"
#define SUNNY "<sky type='iso-12' sun-altitude='35' sun-bearing='170'/>"

static const struct {
    const char *name, *xml;
    bool gloss;
    double error;
} rooms[] = {
    {"wide windows", PLAN WINDOW("3.2", "1.8", "0.9"), false, 0.01},
    {"small windows",
     PLAN "<window wall='south' left='0.9' sill='1.2' width='0.5' height='0.6'/>"
          "<window wall='west' left='2.9' sill='1.2' width='0.4' height='0.7'/>",
     false, 0.01},
    {"light well", PLAN WINDOW("3.2", "1.8", "0.9") WELL, false, 0.03},
    {"mirror",
     PLAN WINDOW("3.2", "1.8", "0.9") "<finish wall='north' reflectance='mirror'/>",
     true, 0.01},
    {"sun, without its disc", SUNNY PLAN WINDOW("3.2", "1.8", "0.9"), false, 0.01},
    {"not convex",
     "<plan height='3'><vertex x='0' y='0'/><vertex x='6' y='0'/>"
     "<vertex x='6' y='2.5'/><vertex x='2.5' y='2.5'/><vertex x='2.5' y='6'/>"
     "<vertex x='0' y='6'/></plan>"
     "<window wall='1' left='0.6' sill='0.8' width='2.1' height='1.6'/>",
     false, 0.01},
};

int main(void)
{
    for (size_t i = 0; i < sizeof rooms / sizeof *rooms; i++)
        for (int fine = 0; fine < 2; fine++) {
            char xml[4096];
            snprintf(xml, sizeof xml, "<room version='1'>%s%s</room>", rooms[i].xml,
                     fine ? GRID("0.25") : GRID("1.2"));
            if (!fine || !rooms[i].gloss)
                bench_room(rooms[i].name, xml, rooms[i].gloss, rooms[i].error);
        }
    return 0;
}
