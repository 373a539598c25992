/* bench_skies.c - time for a simulation under each of a hundred skies; the scene is
 * built only once. */
#include "bench/bench.h"
#include "simulate/scene/light_scene_parts.h"
#include "simulate/fast/tracer.h"

enum { SKIES = 100 };

/* An office with louvres, whose many surfaces make a build expensive. */
static struct pp_world *office(void)
{
    static char xml[1 << 16];
    int at = sprintf(xml, "<room version='1'><plan width='3.6' depth='6' height='2.8'/>"
                          "<finishes floor='0.25' walls='0.6' ceiling='0.75'/>"
                          "<window wall='south' left='0.4' sill='0.8' width='2.8' "
                          "height='1.6'/><grid spacing='1' margin='0.5'/>");
    for (int i = 0; i < 200; i++) {
        double z = 0.8 + 0.008 * i;
        at += sprintf(xml + at,
                      "<surface><vertex x='0.4' y='-0.05' z='%g'/>"
                      "<vertex x='3.2' y='-0.05' z='%g'/>"
                      "<vertex x='3.2' y='-0.1' z='%g'/>"
                      "<vertex x='0.4' y='-0.1' z='%g'/></surface>",
                      z, z, z, z);
    }
    sprintf(xml + at, "</room>");
    struct pp_outside_light own;
    return world_of(&own, xml);
}

static struct pp_outside_light light_of(int number)
{
    struct pp_outside_light light = {.ground_reflectance = 0.2};
    struct pp_error err;
    double altitude = (5.0 + 0.8 * number) * PP_RAD, bearing = 0.37 * number;
    struct pp_vec3 sun = pp_vec(cos(altitude) * sin(bearing),
                                cos(altitude) * cos(bearing), sin(altitude));
    must(pp_sky_iso(&light.sky, 1 + number % 15, sun, &err), &err);
    return light;
}

int main(void)
{
    struct pp_world *world = office();
    struct pp_light_scene *scene;
    struct pp_error err;
    double start = processor_s(), lights = 0.0, integrated = 0.0, sum = 0.0;
    must(pp_light_scene_of_world_matt(&scene, world, &err), &err);
    double built = processor_s() - start;
    for (int i = 0; i < SKIES; i++) {
        const struct pp_tracer_options options = {.samples = 16, .threads = 1};
        struct pp_outside_light light = light_of(i);
        struct pp_environment *environment;
        struct pp_tracer *tracer;
        start = processor_s();
        must(pp_light_scene_under(&environment, scene, &light, &err), &err);
        lights += processor_s() - start;
        start = processor_s();
        must(pp_tracer_create(&tracer, scene, environment, world->receivers,
                              world->receiver_count, &options, &err),
             &err);
        while (!pp_tracer_done(tracer))
            must(pp_tracer_advance(tracer, 10.0, &err), &err);
        integrated += processor_s() - start;
        struct pp_reading readings[PP_COMPONENT_COUNT];
        pp_tracer_read(tracer, 0, readings);
        sum += readings[PP_DF].value;
        pp_tracer_destroy(tracer);
        pp_environment_destroy(environment);
    }
    printf("100 skies over one scene of %d triangles, %d points:\n",
           scene->triangle_count, world->receiver_count);
    printf(
        "  building %.2f ms; lighting by 100 skies %.3f ms; 100 integrations %.2f s\n",
        1e3 * built, 1e3 * lights, integrated);
    printf("  mean at the first point %.3f %%\n", 100.0 * sum / SKIES);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
    return 0;
}
