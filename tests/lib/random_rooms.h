/* random_rooms.h - box rooms with one to three openings, and their sky components by
 * quadrature: an independent calculation for tests. */
#ifndef PP_TESTS_LIB_RANDOM_ROOMS_H
#define PP_TESTS_LIB_RANDOM_ROOMS_H

#include <stdio.h>
#include <stdlib.h>

#include "simulate/sampling/hash.h"
#include "tests/lib/room_of.h"
#include "tests/lib/traced.h"

/* Next number of a series, uniform in [low, high). */
static inline double pp_test_random(uint64_t *series, double low, double high)
{
    *series = pp_hash(*series, 1);
    return low + (high - low) * (double)(*series >> 11) * 0x1p-53;
}

/* A room with one or two windows, or two windows and a rooflight; glazed or not; under
 * an overcast, uniform or clear sky. `count` receivers facing up are on its working
 * plane, at least 0.3 m from the walls. */
static inline struct pp_world *pp_test_random_room(struct pp_outside_light *light,
                                                   uint64_t number, int count)
{
    uint64_t series = pp_hash(271828, number);
    double width = pp_test_random(&series, 2.5, 8.0);
    double depth = pp_test_random(&series, 2.5, 8.0);
    double height = pp_test_random(&series, 2.3, 4.0);
    const char *skies[] = {"type='overcast'", "type='overcast'", "type='uniform'",
                           "type='iso-12' sun-altitude='35' sun-bearing='160'"};
    const char *glazings[] = {"none", "clear-single", "clear-double"};
    const char *walls[] = {"south", "east", "north", "west"};
    char xml[8192];
    int n =
        snprintf(xml, sizeof xml,
                 "<room version='1'><sky %s/><plan width='%.3f' depth='%.3f' "
                 "height='%.3f'/><finishes floor='%.2f' walls='%.2f' "
                 "ceiling='%.2f'/>",
                 skies[(int)pp_test_random(&series, 0.0, 4.0)], width, depth, height,
                 pp_test_random(&series, 0.1, 0.5), pp_test_random(&series, 0.2, 0.8),
                 pp_test_random(&series, 0.3, 0.9));
    int windows = (int)pp_test_random(&series, 1.0, 4.0);
    int first = (int)pp_test_random(&series, 0.0, 4.0);
    for (int i = 0; i < windows; i++) {
        int wall = (first + i) % 4;
        const char *glazing = glazings[(int)pp_test_random(&series, 0.0, 3.0)];
        double length = wall % 2 ? depth : width;
        double wide = pp_test_random(&series, 0.3, 0.9) * length;
        double left = pp_test_random(&series, 0.05, 0.95) * (length - wide);
        double sill = pp_test_random(&series, 0.1, 0.5) * height;
        double high = pp_test_random(&series, 0.3, 0.9) * (height - sill);
        if (i == 2)
            n += snprintf(xml + n, sizeof xml - (size_t)n,
                          "<rooflight x='%.3f' y='%.3f' width='%.3f' depth='%.3f' "
                          "glazing='%s'/>",
                          0.2 * width, 0.3 * depth, 0.3 * width, 0.4 * depth, glazing);
        else
            n += snprintf(xml + n, sizeof xml - (size_t)n,
                          "<window wall='%s' left='%.3f' sill='%.3f' width='%.3f' "
                          "height='%.3f' glazing='%s'/>",
                          walls[wall], left, sill, wide, high, glazing);
    }
    for (int i = 0; i < count; i++)
        n += snprintf(xml + n, sizeof xml - (size_t)n, "<point x='%.3f' y='%.3f'/>",
                      pp_test_random(&series, 0.3, width - 0.3),
                      pp_test_random(&series, 0.3, depth - 0.3));
    snprintf(xml + n, sizeof xml - (size_t)n, "</room>");
    return pp_test_lit_world(light, xml);
}

/* Light per square metre from a point of an opening's plane. */
static inline double pp_test_sky_from(const struct pp_outside_light *light,
                                      const struct pp_opening *opening,
                                      const struct pp_receiver *receiver,
                                      struct pp_vec3 point)
{
    struct pp_vec3 v = pp_vec_sub(point, receiver->position);
    double r = pp_vec_length(v);
    struct pp_vec3 u = pp_vec_scale(v, 1.0 / r);
    double facing = pp_vec_dot(receiver->normal, u);
    double cosine = -pp_vec_dot(opening->inner.normal, u);
    if (!(facing > 0.0 && cosine > 0.0))
        return 0.0;
    return pp_sky_luminance(&light->sky, u) * facing * cosine / (r * r)
           * pp_glass_transmittance(&opening->glass, cosine) * opening->frame_factor
           * opening->maintenance * opening->curtains;
}

/* Sky component of a receiver that faces up, by Gauss-Legendre quadrature of each
 * opening (a rectangle with edges along x, y or z) in 10 x 10 panels of 6 x 6 nodes: a
 * relative error of 1e-7 from 0.3 m. */
static inline double pp_test_sky_component(const struct pp_world *world,
                                           const struct pp_outside_light *light,
                                           const struct pp_receiver *receiver)
{
    static const double node[6] = {0.033765242898424, 0.169395306766868,
                                   0.380690406958402, 0.619309593041598,
                                   0.830604693233132, 0.966234757101576};
    static const double weight[6] = {0.085662246189585, 0.180380786524069,
                                     0.233956967286346, 0.233956967286346,
                                     0.180380786524069, 0.085662246189585};
    enum { PANELS = 10 };
    double sum = 0.0;
    for (int k = 0; k < world->opening_count; k++) {
        const struct pp_opening *opening = &world->openings[k];
        struct pp_vec3 low = opening->inner.vertices[0], high = low;
        for (int i = 0; i < 4; i++) {
            struct pp_vec3 v = opening->inner.vertices[i];
            low = pp_vec(fmin(low.x, v.x), fmin(low.y, v.y), fmin(low.z, v.z));
            high = pp_vec(fmax(high.x, v.x), fmax(high.y, v.y), fmax(high.z, v.z));
        }
        low.z = fmax(low.z, receiver->position.z); /* lower parts are behind the
                                                    * receiver */
        if (high.z < low.z)
            continue;
        bool flat = fabs(opening->inner.normal.z) > 0.5;
        struct pp_vec3 a = pp_vec(high.x - low.x, flat ? 0.0 : high.y - low.y, 0.0);
        struct pp_vec3 b =
            flat ? pp_vec(0.0, high.y - low.y, 0.0) : pp_vec(0.0, 0.0, high.z - low.z);
        double scale = pp_vec_length(a) * pp_vec_length(b) / (PANELS * PANELS);
        for (int i = 0; i < PANELS * 6; i++)
            for (int j = 0; j < PANELS * 6; j++) {
                double s = (i / 6 + node[i % 6]) / PANELS;
                double t = (j / 6 + node[j % 6]) / PANELS;
                sum += scale * weight[i % 6] * weight[j % 6]
                       * pp_test_sky_from(light, opening, receiver,
                                          pp_vec_along(pp_vec_along(low, s, a), t, b));
            }
    }
    return sum;
}

/* Counts of values by their distance from the reference in standard errors. */
struct pp_coverage {
    int count, within_1, within_2, beyond_4;
};

static inline void pp_coverage_add(struct pp_coverage *coverage,
                                   struct pp_reading reading, double truth)
{
    double off = fabs(reading.value - truth) / reading.std_error;
    coverage->count++;
    coverage->within_1 += off < 1.0;
    coverage->within_2 += off < 2.0;
    coverage->beyond_4 += !(off < 4.0);
}

/* Traces `rooms` rooms of 10 points to 1 % and compares sky components above 0.01 %. */
static inline struct pp_coverage pp_test_sky_coverage(int first, int rooms)
{
    struct pp_coverage coverage = {0, 0, 0, 0};
    for (int room = first; room < first + rooms; room++) {
        struct pp_outside_light light;
        struct pp_world *world = pp_test_random_room(&light, (uint64_t)room, 10);
        struct pp_tracer_options options = {.error = 0.01, .seed = (uint64_t)room};
        struct pp_reading(*traced)[4] =
            pp_test_trace(world, &light, world->receivers, 10, &options, NULL);
        for (int i = 0; i < 10; i++) {
            double truth = pp_test_sky_component(world, &light, &world->receivers[i]);
            if (truth > 1e-4)
                pp_coverage_add(&coverage, traced[i][PP_SC], truth);
        }
        free(traced);
        pp_world_destroy(world);
    }
    return coverage;
}

/* Traces a few points of `rooms` rooms to 3 % with `seeds` seeds, and compares each
 * daylight factor, and the average, with its mean over the seeds. */
static inline struct pp_coverage pp_test_df_coverage(int first, int rooms, int seeds)
{
    struct pp_coverage coverage = {0, 0, 0, 0};
    enum { POINTS = 4 };
    struct pp_reading(*all)[POINTS + 1] = calloc((size_t)seeds, sizeof *all);
    for (int room = first; room < first + rooms; room++) {
        struct pp_outside_light light;
        struct pp_world *world = pp_test_random_room(&light, (uint64_t)room, POINTS);
        for (int seed = 0; seed < seeds; seed++) {
            struct pp_tracer_options options = {
                .error = 0.03, .seed = (uint64_t)seed, .average = true};
            struct pp_reading(*traced)[4] =
                pp_test_trace(world, &light, world->receivers, POINTS, &options, NULL);
            for (int i = 0; i <= POINTS; i++)
                all[seed][i] = traced[i][PP_DF];
            free(traced);
        }
        for (int i = 0; i <= POINTS; i++) {
            double mean = 0.0;
            for (int seed = 0; seed < seeds; seed++)
                mean += all[seed][i].value / seeds;
            for (int seed = 0; seed < seeds; seed++) {
                /* Corrects for the mean's dependence on this value. */
                all[seed][i].std_error *= sqrt(1.0 - 1.0 / seeds);
                pp_coverage_add(&coverage, all[seed][i], mean);
            }
        }
        pp_world_destroy(world);
    }
    free(all);
    return coverage;
}

#endif
