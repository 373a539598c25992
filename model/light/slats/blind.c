/* blind.c - see blind.h. Light that slats and glass reflect between them is sorted into
 * bins of its profile angle. Reflections are added until less than 1e-9 of the light is
 * left. */
#include "model/light/slats/blind.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/error.h"
#include "model/light/slats/blind_scatter.h"

enum { BINS = PP_SLAT_BINS, QUARTER = PP_SLAT_BINS / 4, PASSES = 100 };

#define BIN_RAD (2.0 * PP_PI / BINS)
#define LEAST 1e-9

/* Response of slats and glass to light in each bin of directions, over the full
 * circle. */
struct blind_response {
    double slats[BINS][BINS]; /* [i][k]: light that leaves in k per light in i */
    double glass[BINS]; /* reflectance of the pane that light leaving in k meets */
};

/* True for light that travels into the room. */
static bool is_inwards(int bin)
{
    return bin >= QUARTER && bin < 3 * QUARTER;
}

static double bin_middle(int bin)
{
    return -PP_PI + (bin + 0.5) * BIN_RAD;
}

/* Bin after reflection in the glass. */
static int mirrored_bin(int bin)
{
    return (BINS + BINS / 2 - 1 - bin) % BINS;
}

static void find_response(struct blind_response *response, const struct pp_blind *blind,
                          const struct pp_slat_cell *cell)
{
    for (int i = 0; i < BINS; i++) {
        struct pp_slat_light light;
        pp_slat_cell_light(cell, bin_middle(i), &light);
        memcpy(response->slats[i], light.leaving, sizeof light.leaving);
        response->slats[i][i] += light.straight;
        const struct pp_glass *pane = is_inwards(i) ? &blind->inner : &blind->outer;
        response->glass[i] =
            pane->panes > 0
                ? pp_blind_scatter_mean(pp_glass_reflectance, pane, bin_middle(i))
                : 0.0;
    }
}

/* Adds to `leaving` the light that leaves the slats after reflections in the glass.
 * returning: light that leaves the slats towards the glass; overwritten. */
static void add_returns(const struct blind_response *response, double leaving[BINS],
                        double returning[BINS])
{
    double left = 1.0;
    for (int pass = 0; pass < PASSES && left > LEAST; pass++) {
        double next[BINS] = {0};
        left = 0.0;
        for (int i = 0; i < BINS; i++) {
            double back = returning[i] * response->glass[i];
            if (back == 0.0)
                continue;
            left += back;
            for (int k = 0; k < BINS; k++)
                next[k] += back * response->slats[mirrored_bin(i)][k];
        }
        for (int k = 0; k < BINS; k++)
            leaving[k] += next[k];
        memcpy(returning, next, sizeof next);
    }
}

static void find_through(struct pp_blind *blind, const struct pp_slat_cell *cell,
                         const struct blind_response *response)
{
    for (int i = 0; i <= PP_BLIND_CELLS; i++) {
        double p = -0.5 * PP_PI + i * PP_PI / PP_BLIND_CELLS;
        struct pp_slat_light light;
        double returning[BINS];
        pp_slat_cell_light(cell, fmax(-89.9 * PP_RAD, fmin(p, 89.9 * PP_RAD)), &light);
        memcpy(returning, light.leaving, sizeof returning);
        int bin = QUARTER + (i < PP_BLIND_CELLS ? i / 2 : BINS / 2 - 1);
        returning[bin] += light.straight;
        add_returns(response, light.leaving, returning);
        memcpy(blind->through[i], light.leaving + QUARTER, sizeof blind->through[i]);
    }
}

/* Reflectance for uniform light from the room, or from outside. */
static double even_reflectance(const struct pp_blind *blind,
                               const struct blind_response *response, bool from_room)
{
    const struct pp_glass *pane = from_room ? &blind->inner : &blind->outer;
    double leaving[BINS] = {0}, returning[BINS], sum = 0.0;
    for (int i = 0; i < BINS; i++) {
        if (is_inwards(i) == from_room)
            continue;
        double light = 0.5
                       * fabs(sin(bin_middle(i) + 0.5 * BIN_RAD)
                              - sin(bin_middle(i) - 0.5 * BIN_RAD));
        double passes = pp_blind_scatter_mean(pp_glass_transmittance, pane,
                                              bin_middle(mirrored_bin(i)));
        sum += pane->panes > 0
                   ? light
                         * pp_blind_scatter_mean(pp_glass_reflectance, pane,
                                                 bin_middle(mirrored_bin(i)))
                   : 0.0;
        for (int k = 0; k < BINS; k++)
            leaving[k] += light * passes * response->slats[i][k];
    }
    memcpy(returning, leaving, sizeof returning);
    add_returns(response, leaving, returning);
    for (int k = 0; k < BINS; k++)
        if (is_inwards(k) == from_room)
            sum += leaving[k]
                   * pp_blind_scatter_mean(pp_glass_transmittance, pane, bin_middle(k));
    return fmin(1.0, sum);
}

static double diffuse_through(const struct pp_slat_cell *cell, double low, double high)
{
    struct pp_slat_light light;
    pp_slat_cell_diffuse(cell, low, high, &light);
    struct pp_slat_parts parts = pp_slat_cell_parts(&light);
    return parts.straight + parts.room_down + parts.room_up;
}

static void find_hand_figures(struct pp_blind *blind, const struct pp_slat_cell *cell,
                              bool upright)
{
    blind->sky = diffuse_through(cell, 0.0, 0.5 * PP_PI);
    blind->ground = diffuse_through(cell, -0.5 * PP_PI, 0.0);
    blind->all = diffuse_through(cell, -0.5 * PP_PI, 0.5 * PP_PI);
    blind->mean = upright && !blind->device.vertical
                      ? 0.8 * blind->sky + 0.2 * blind->ground
                      : blind->all;
}

/* Glazing that consists of `panes` of the panes of `glass`. */
static struct pp_glass part_of_glass(const struct pp_glass *glass, int panes)
{
    if (panes == glass->panes)
        return *glass;
    if (panes == 0)
        return pp_glass_none();
    struct pp_glass part = pp_glass_panes(panes, glass->n, glass->kl);
    double scale = pow(glass->scale, (double)panes / glass->panes);
    return scale == 1.0 ? part : pp_glass_scaled(part, part.normal * scale);
}

static void divide_glass(struct pp_blind *blind, const struct pp_glass *glass)
{
    enum pp_device_position position = blind->device.position;
    int outer = position == PP_DEVICE_INSIDE    ? glass->panes
                : position == PP_DEVICE_OUTSIDE ? 0
                                                : 1;
    blind->glass = *glass;
    blind->outer = part_of_glass(glass, outer);
    blind->inner = part_of_glass(glass, glass->panes - outer);
    for (int i = 0; i < PP_BLIND_CELLS; i++)
        blind->outer_mean[i] =
            pp_blind_scatter_mean(pp_glass_transmittance, &blind->outer,
                                  -0.5 * PP_PI + (i + 0.5) * PP_PI / PP_BLIND_CELLS);
    for (int j = 0; j < PP_BLIND_BINS; j++)
        blind->inner_mean[j] = pp_blind_scatter_mean(
            pp_glass_transmittance, &blind->inner, bin_middle(QUARTER + j));
}

/* FNV-1a of slats, glass and position, which determine the tables. */
static uint64_t hash_of_blind(const struct pp_blind *blind)
{
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    const struct pp_slats *slats = &blind->device.slats;
    const double numbers[] = {slats->width,        slats->spacing,
                              slats->tilt_rad,     slats->rise,
                              slats->upper,        slats->lower,
                              blind->glass.normal, blind->device.vertical,
                              blind->glass.panes,  blind->device.position,
                              blind->glass.kl,     blind->glass.n};
    const unsigned char *bytes = (const unsigned char *)numbers;
    for (size_t i = 0; i < sizeof numbers; i++)
        hash = (hash ^ bytes[i]) * UINT64_C(0x100000001b3);
    return hash;
}

enum pp_status pp_blind_create(struct pp_blind **made,
                               const struct pp_window_device *device,
                               const struct pp_glass *glass, bool upright,
                               struct pp_error *err)
{
    struct pp_slat_cell *cell = NULL;
    enum pp_status status = pp_slat_cell_create(&cell, &device->slats, err);
    if (status != PP_OK)
        return status;
    struct pp_blind *blind = calloc(1, sizeof *blind);
    struct blind_response *response = malloc(sizeof *response);
    if (blind && response) {
        blind->device = *device;
        blind->holders = 1;
        divide_glass(blind, glass);
        find_response(response, blind, cell);
        find_through(blind, cell, response);
        find_hand_figures(blind, cell, upright);
        pp_blind_scatter_init(blind);
        blind->scatter.id = hash_of_blind(blind);
        blind->scatter.reflect_room = even_reflectance(blind, response, true);
        blind->scatter.reflect_outside = even_reflectance(blind, response, false);
        *made = blind;
    } else {
        free(blind);
        status = pp_fail_memory(err);
    }
    free(response);
    pp_slat_cell_destroy(cell);
    return status;
}

void pp_blind_release(struct pp_blind *blind)
{
    if (!blind || --blind->holders > 0)
        return;
    pp_blind_release(blind->for_sun);
    free(blind);
}
