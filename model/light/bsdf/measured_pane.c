/* measured_pane.c - see measured_pane.h. */
#include "model/light/bsdf/measured_pane.h"

#include <stdlib.h>
#include <string.h>

/* ---- the functions of pane_scatter.h ---- */

static const struct pp_measured_way *way_of(const struct pp_measured_pane *pane,
                                            struct pp_vec3 travel)
{
    return travel.z > 0.0 ? &pane->into_room : &pane->out_of_room;
}

static double straight_share(const void *data, struct pp_vec3 in)
{
    const struct pp_measured_way *way = way_of(data, in);
    return way->straight[pp_angle_basis_find(&way->in, in)];
}

static double scattered_share(const void *data, struct pp_vec3 in)
{
    const struct pp_measured_way *way = way_of(data, in);
    return way->through[pp_angle_basis_find(&way->in, in)];
}

static double value_of(const struct pp_measured_way *way, int out, int in)
{
    return way->scattered[out * way->in.count + in];
}

static double measured_btdf(const void *data, struct pp_vec3 in, struct pp_vec3 out)
{
    const struct pp_measured_way *way = way_of(data, in);
    return value_of(way, pp_angle_basis_find(&way->out, out),
                    pp_angle_basis_find(&way->in, in));
}

static double arriving_sum(const struct pp_measured_way *way, int out)
{
    return way->cumulative[(out + 1) * way->in.count - 1];
}

static double measured_arriving(const void *data, struct pp_vec3 out)
{
    const struct pp_measured_way *way = way_of(data, out);
    return arriving_sum(way, pp_angle_basis_find(&way->out, out));
}

/* Draws a patch in proportion to f W, and a direction in that patch. u is used for
 * both. */
static double measured_sample(const void *data, struct pp_vec3 out, double u, double v,
                              struct pp_vec3 *in)
{
    const struct pp_measured_way *way = way_of(data, out);
    int leaving = pp_angle_basis_find(&way->out, out);
    const double *sums = way->cumulative + leaving * way->in.count;
    double left = u * arriving_sum(way, leaving);
    int low = 0, high = way->in.count - 1; /* the first patch whose sum exceeds left */
    while (low < high) {
        int middle = (low + high) / 2;
        if (sums[middle] > left)
            high = middle;
        else
            low = middle + 1;
    }
    double before = low > 0 ? sums[low - 1] : 0.0, own = sums[low] - before;
    if (!(own > 0.0))
        return 0.0;
    *in = pp_angle_basis_direction(&way->in, low, fmin((left - before) / own, 1.0), v);
    if (!(out.z > 0.0))
        in->z = -in->z;
    return 1.0;
}

static double measured_density(const void *data, struct pp_vec3 in, struct pp_vec3 out)
{
    double sum = measured_arriving(data, out);
    return sum > 0.0 ? measured_btdf(data, in, out) * fabs(in.z) / sum : 0.0;
}

static int leaving_class(const void *data, struct pp_vec3 out)
{
    const struct pp_measured_pane *pane = data;
    return pp_angle_basis_find(&pane->into_room.out, out);
}

static double class_value(const void *data, struct pp_vec3 in, int class_index)
{
    const struct pp_measured_pane *pane = data;
    return value_of(&pane->into_room, class_index,
                    pp_angle_basis_find(&pane->into_room.in, in));
}

/* ---- making one ---- */

/* Moves the unscattered light of a patch out of the matrix. */
static void split_patch(struct pp_measured_way *way, int patch)
{
    static const double PEAK = 2.0; /* relative to the adjacent patches */
    double around = 0.0, *own = &way->scattered[patch * way->in.count + patch];
    for (int out = 0; out < way->out.count; out++)
        if (pp_angle_basis_is_adjacent(&way->out, out, patch))
            around = fmax(around, value_of(way, out, patch));
    if (!(*own > PEAK * around))
        return;
    way->straight[patch] = (*own - around) * pp_angle_basis_projected(&way->out, patch);
    *own = around;
}

static enum pp_status make_way(struct pp_measured_way *way,
                               const struct pp_bsdf_block *block, bool split,
                               struct pp_error *err)
{
    size_t ins = (size_t)block->in.count, outs = (size_t)block->out.count;
    way->in = block->in;
    way->out = block->out;
    way->scattered = malloc(ins * outs * sizeof(double));
    way->cumulative = malloc(ins * outs * sizeof(double));
    way->straight = calloc(ins, sizeof(double));
    way->through = calloc(ins, sizeof(double));
    if (!way->scattered || !way->cumulative || !way->straight || !way->through)
        return pp_fail_memory(err);
    memcpy(way->scattered, block->values, ins * outs * sizeof(double));
    if (split && pp_angle_basis_is_same(&way->in, &way->out))
        for (int i = 0; i < way->in.count; i++)
            split_patch(way, i);
    for (int out = 0; out < way->out.count; out++) {
        double sum = 0.0, W = pp_angle_basis_projected(&way->out, out);
        for (int in = 0; in < way->in.count; in++) {
            double f = value_of(way, out, in);
            way->through[in] += f * W;
            sum += f * pp_angle_basis_projected(&way->in, in);
            way->cumulative[out * way->in.count + in] = sum;
        }
    }
    return PP_OK;
}

static void clear_way(struct pp_measured_way *way)
{
    free(way->scattered);
    free(way->cumulative);
    free(way->straight);
    free(way->through);
}

static double mean_over(const struct pp_angle_basis *basis, const double *values)
{
    double sum = 0.0;
    for (int i = 0; i < basis->count; i++)
        sum += values[i] * pp_angle_basis_projected(basis, i);
    return sum / PP_PI;
}

static enum pp_measured_kind kind_of(const struct pp_measured_pane *pane)
{
    static const double CLEAR = 0.98, LAMBERTIAN = 0.05;
    const struct pp_measured_way *way = &pane->into_room;
    if (pane->straight_diffuse > CLEAR * pane->diffuse && pane->normal > 0.0)
        return PP_MEASURED_CLEAR;
    double apart = PP_PI * pane->straight_diffuse; /* sum of |f - Lambertian f| W W */
    for (int out = 0; out < way->out.count; out++)
        for (int in = 0; in < way->in.count; in++)
            apart += fabs(value_of(way, out, in) - pane->diffuse / PP_PI)
                     * pp_angle_basis_projected(&way->out, out)
                     * pp_angle_basis_projected(&way->in, in);
    return apart < LAMBERTIAN * PP_PI * pane->diffuse ? PP_MEASURED_DIFFUSING
                                                      : PP_MEASURED_SCATTERING;
}

static enum pp_status fill_pane(struct pp_measured_pane *pane,
                                const struct pp_bsdf *bsdf, bool split,
                                struct pp_error *err)
{
    const struct pp_bsdf_block *blocks = bsdf->blocks;
    const struct pp_bsdf_block *front = &blocks[PP_BSDF_THROUGH_FRONT];
    enum pp_status status = make_way(&pane->into_room, front, split, err);
    if (status == PP_OK)
        status =
            make_way(&pane->out_of_room, &blocks[PP_BSDF_THROUGH_BACK], split, err);
    if (status != PP_OK)
        return status;
    pane->normal = pp_bsdf_block_direct(
        front, pp_angle_basis_find(&front->in, pp_vec(0.0, 0.0, 1.0)));
    pane->diffuse = pp_bsdf_block_hemispherical(front);
    pane->straight_diffuse = mean_over(&pane->into_room.in, pane->into_room.straight);
    if (!(pane->diffuse > 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "the glazing system transmits no light; expected a "
                       "transmittance above 0");
    pane->kind = kind_of(pane);
    memcpy(pane->name, bsdf->name, sizeof pane->name);
    memcpy(pane->warnings, bsdf->warnings, sizeof pane->warnings);
    pane->warning_count = bsdf->warning_count;
    return PP_OK;
}

static const struct pp_angle_basis *basis_of(const struct pp_measured_pane *pane)
{
    const struct pp_measured_way *way = &pane->into_room;
    return pp_angle_basis_is_same(&way->in, &way->out) ? &way->in : NULL;
}

/* FNV-1a. */
static uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t count)
{
    const unsigned char *at = bytes;
    for (size_t i = 0; i < count; i++)
        hash = (hash ^ at[i]) * UINT64_C(0x100000001b3);
    return hash;
}

static uint64_t hash_of(const struct pp_measured_pane *pane)
{
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    const struct pp_measured_way *ways[2] = {&pane->into_room, &pane->out_of_room};
    for (int i = 0; i < 2; i++) {
        size_t ins = (size_t)ways[i]->in.count, outs = (size_t)ways[i]->out.count;
        hash = hash_bytes(hash, ways[i]->scattered, ins * outs * sizeof(double));
        hash = hash_bytes(hash, ways[i]->straight, ins * sizeof(double));
    }
    return hash;
}

enum pp_status pp_measured_pane_create(struct pp_measured_pane **result,
                                       const struct pp_bsdf *bsdf, bool split,
                                       struct pp_error *err)
{
    *result = NULL;
    struct pp_measured_pane *pane = calloc(1, sizeof *pane);
    if (!pane)
        return pp_fail_memory(err);
    pane->holders = 1;
    pane->is_split = split;
    enum pp_status status = fill_pane(pane, bsdf, split, err);
    if (status != PP_OK) {
        pp_measured_pane_release(pane);
        return status;
    }
    const struct pp_bsdf_block *blocks = bsdf->blocks;
    double outside = pp_bsdf_block_hemispherical(&blocks[PP_BSDF_REFLECT_FRONT]);
    double room = pp_bsdf_block_hemispherical(&blocks[PP_BSDF_REFLECT_BACK]);
    pane->scatter = (struct pp_pane_scatter){.data = pane,
                                             .id = hash_of(pane),
                                             .reflect_outside = fmin(1.0, outside),
                                             .reflect_room = fmin(1.0, room),
                                             .straight = straight_share,
                                             .scattered = scattered_share,
                                             .btdf = measured_btdf,
                                             .arriving = measured_arriving,
                                             .sample = measured_sample,
                                             .density = measured_density,
                                             .splits = split,
                                             .basis = basis_of(pane),
                                             .class_count = pane->into_room.out.count,
                                             .class_of = leaving_class,
                                             .class_btdf = class_value};
    *result = pane;
    return PP_OK;
}

struct pp_measured_pane *pp_measured_pane_hold(struct pp_measured_pane *pane)
{
    if (pane)
        __atomic_add_fetch(&pane->holders, 1, __ATOMIC_RELAXED);
    return pane;
}

void pp_measured_pane_release(struct pp_measured_pane *pane)
{
    if (!pane || __atomic_sub_fetch(&pane->holders, 1, __ATOMIC_ACQ_REL) > 0)
        return;
    clear_way(&pane->into_room);
    clear_way(&pane->out_of_room);
    free(pane->file);
    free(pane);
}
