/* cache_entry.c - the normalised distance of a place from a record, and the irradiance
 * that the record gives there. */
#include "simulate/cache/cache_entry.h"

#include <math.h>

/* 1 - cos(20 degrees): the turn of the surface normal at which the weight of a record
 * reaches 0. */
static const double MOST_TURN = 0.0603;

/* A displacement along the record's normal counts this many times as much as a
 * displacement along the smaller axis. Chosen by trial, like BEHIND. */
static const double STEP = 4.0;

/* Distance behind the record, relative to its smaller radius, beyond which a place may
 * not see the same surroundings. */
static const double BEHIND = 0.05;

static const double NEVER = 1e30;

int pp_cache_entry_sector(double along_a, double along_b)
{
    /* The diamond angle instead of the true angle: any monotone measure of azimuth is
     * enough. */
    double sum = fabs(along_a) + fabs(along_b);
    if (!(sum > 0.0))
        return 0;
    double t = along_b / sum;
    double turn = along_a >= 0.0 ? (along_b >= 0.0 ? t : 4.0 + t) : 2.0 - t;
    int sector = (int)(turn * (PP_CACHE_SECTORS / 4));
    return sector < PP_CACHE_SECTORS ? sector : PP_CACHE_SECTORS - 1;
}

double pp_cache_entry_distance(const struct pp_cache_entry *entry,
                               const struct pp_cache_place *place, double most)
{
    const struct pp_cache_record *is = &entry->is;
    double facing = pp_vec_dot(place->normal, is->normal);
    if (facing < 1.0 - MOST_TURN || place->space != is->space)
        return NEVER;
    struct pp_vec3 off = pp_vec_sub(place->point, is->point);
    double x = pp_vec_dot(off, is->axes[0]) / is->radii_m[0];
    double y = pp_vec_dot(off, is->axes[1]) / is->radii_m[1];
    double step = pp_vec_dot(off, is->normal);
    double z = STEP * step / is->radii_m[0];
    double turn = facing < 1.0 ? (1.0 - facing) / MOST_TURN : 0.0;
    double square = x * x + y * y + z * z + turn;
    if (square > most * most)
        return NEVER;
    double behind = 0.5 * (step + pp_vec_dot(off, place->normal));
    if (behind < -BEHIND * is->radii_m[0])
        return NEVER;
    double u = pp_vec_dot(off, entry->a), v = pp_vec_dot(off, entry->b);
    double clear = entry->horizon_m[pp_cache_entry_sector(u, v)];
    return u * u + v * v > clear * clear ? NEVER : sqrt(square);
}

void pp_cache_entry_unsmooth(struct pp_cache_entry *entry)
{
    entry->value = entry->is.value;
    for (int c = 0; c < 3; c++)
        entry->along[c] = entry->is.along[c];
}

static double read_channel(double value, struct pp_vec3 along, struct pp_vec3 off,
                           struct pp_vec3 turned, struct pp_vec3 turn)
{
    double there = value + pp_vec_dot(along, off) + pp_vec_dot(turned, turn);
    return there > 0.0 ? there : 0.0;
}

struct pp_rgb pp_cache_entry_read(const struct pp_cache_entry *entry,
                                  const struct pp_cache_place *place)
{
    const struct pp_cache_record *is = &entry->is;
    struct pp_vec3 off = pp_vec_sub(place->point, is->point);
    struct pp_vec3 turn = pp_vec_sub(place->normal, is->normal);
    const struct pp_vec3 *along = entry->along, *turned = is->turned;
    return pp_rgb(read_channel(entry->value.r, along[0], off, turned[0], turn),
                  read_channel(entry->value.g, along[1], off, turned[1], turn),
                  read_channel(entry->value.b, along[2], off, turned[2], turn));
}
