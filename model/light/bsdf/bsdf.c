/* bsdf.c - see bsdf.h. */
#include "model/light/bsdf/bsdf.h"

#include <stdarg.h>
#include <stdlib.h>

#include "model/base/text.h"

void pp_bsdf_clear(struct pp_bsdf *bsdf)
{
    for (int i = 0; i < PP_BSDF_PARTS; i++)
        free(bsdf->blocks[i].values);
    *bsdf = (struct pp_bsdf){.warning_count = 0};
}

enum pp_status pp_bsdf_block_init(struct pp_bsdf_block *block, struct pp_error *err)
{
    block->values = calloc((size_t)block->in.count * (size_t)block->out.count + 1,
                           sizeof *block->values);
    return block->values ? PP_OK : pp_fail_memory(err);
}

double pp_bsdf_block_direct(const struct pp_bsdf_block *block, int in)
{
    double sum = 0.0;
    for (int out = 0; block->values && out < block->out.count; out++)
        sum += block->values[out * block->in.count + in]
               * pp_angle_basis_projected(&block->out, out);
    return sum;
}

double pp_bsdf_block_hemispherical(const struct pp_bsdf_block *block)
{
    double sum = 0.0;
    for (int in = 0; block->values && in < block->in.count; in++)
        sum +=
            pp_bsdf_block_direct(block, in) * pp_angle_basis_projected(&block->in, in);
    return sum / PP_PI;
}

void pp_bsdf_warn(struct pp_bsdf *bsdf, const char *format, ...)
{
    if (bsdf->warning_count == PP_BSDF_WARNINGS_MOST)
        return;
    va_list arguments;
    va_start(arguments, format);
    pp_text_append_v(bsdf->warnings[bsdf->warning_count++], PP_BSDF_WARNING, format,
                     arguments);
    va_end(arguments);
}

/* f for light that travels in the opposite directions, by reciprocity. */
static double reversed(const struct pp_bsdf_block *block, int out, int in)
{
    int there = pp_angle_basis_opposite(&block->out, in);
    int here = pp_angle_basis_opposite(&block->in, out);
    return block->values[there * block->in.count + here];
}

static enum pp_status reverse(struct pp_bsdf_block *block,
                              const struct pp_bsdf_block *other, struct pp_error *err)
{
    block->in = other->out;
    block->out = other->in;
    enum pp_status status = pp_bsdf_block_init(block, err);
    for (int out = 0; status == PP_OK && out < block->out.count; out++)
        for (int in = 0; in < block->in.count; in++)
            block->values[out * block->in.count + in] = reversed(other, out, in);
    return status;
}

/* Warns if more light leaves the pane than arrives, for light from one side. */
static void check_energy(struct pp_bsdf *bsdf, enum pp_bsdf_part through,
                         enum pp_bsdf_part reflected, const char *from)
{
    static const double TOLERATED = 1.01; /* allows for rounding in the file */
    const struct pp_bsdf_block *T = &bsdf->blocks[through];
    const struct pp_bsdf_block *R = &bsdf->blocks[reflected];
    double most = 0.0;
    int worst = 0;
    bool both = R->values && pp_angle_basis_is_same(&T->in, &R->in);
    for (int in = 0; in < T->in.count; in++) {
        double sum = pp_bsdf_block_direct(T, in);
        if (both)
            sum += pp_bsdf_block_direct(R, in);
        if (sum > most) {
            most = sum;
            worst = in;
        }
    }
    struct pp_vec3 d = pp_angle_basis_direction(&T->in, worst, 0.5, 0.5);
    if (most > TOLERATED)
        pp_bsdf_warn(
            bsdf,
            "light from %s that arrives at %.0f degrees from the normal leaves "
            "as %.3g times as much light; expected at most 1",
            from, acos(d.z) / PP_RAD, most);
}

/* Warns if transmission from front and back contradicts reciprocity. */
static void check_reciprocity(struct pp_bsdf *bsdf)
{
    static const double TOLERATED = 0.1; /* fraction of all transmitted light */
    const struct pp_bsdf_block *front = &bsdf->blocks[PP_BSDF_THROUGH_FRONT];
    const struct pp_bsdf_block *back = &bsdf->blocks[PP_BSDF_THROUGH_BACK];
    if (!pp_angle_basis_is_same(&front->in, &back->out)
        || !pp_angle_basis_is_same(&front->out, &back->in))
        return;
    double apart = 0.0, sum = 0.0;
    for (int out = 0; out < front->out.count; out++)
        for (int in = 0; in < front->in.count; in++) {
            double W = pp_angle_basis_projected(&front->out, out)
                       * pp_angle_basis_projected(&front->in, in);
            double f = front->values[out * front->in.count + in];
            apart += W * fabs(f - reversed(back, out, in));
            sum += W * f;
        }
    if (apart > TOLERATED * sum)
        pp_bsdf_warn(bsdf,
                     "transmission of the front and of the back contradict each other "
                     "by %.0f %% of the light; expected less than %.0f %%, since light "
                     "takes the same path in both directions",
                     100.0 * apart / sum, 100.0 * TOLERATED);
}

enum pp_status pp_bsdf_complete(struct pp_bsdf *bsdf, struct pp_error *err)
{
    struct pp_bsdf_block *front = &bsdf->blocks[PP_BSDF_THROUGH_FRONT];
    struct pp_bsdf_block *back = &bsdf->blocks[PP_BSDF_THROUGH_BACK];
    enum pp_status status = PP_OK;
    if (front->values && back->values) {
        check_reciprocity(bsdf);
    } else if (front->values) {
        status = reverse(back, front, err);
    } else {
        status = reverse(front, back, err);
        pp_bsdf_warn(bsdf,
                     "the file has no transmission of the front; it was calculated "
                     "from that of the back by reciprocity");
    }
    if (status != PP_OK)
        return status;
    check_energy(bsdf, PP_BSDF_THROUGH_FRONT, PP_BSDF_REFLECT_FRONT, "outside");
    check_energy(bsdf, PP_BSDF_THROUGH_BACK, PP_BSDF_REFLECT_BACK, "the room");
    return PP_OK;
}
