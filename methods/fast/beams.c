/* beams.c - stores the beams of openings, each with a hash table of its areas by
 * direction. */
#include "methods/fast/beams.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Areas along one direction, which points upwards, so that x and y identify it. */
struct known_areas {
    double x, y; /* horizontal components of the direction; x is INFINITY if the slot is
                  * free */
    struct pp_beam_areas areas;
};

/* Hash table of directions. It grows from FIRST slots to MOST (1.3 MB); when the
 * largest table is half full, new directions are not stored. */
enum { FIRST = 1 << 9, MOST = 1 << 15 };

enum { GLASSES = 4 }; /* number of glasses whose means are kept */

/* Work budget for an opening: a second or two of computing time. Overlapping meshes,
 * such as leaves, use it up after far fewer directions than a terrain does. */
static const long long work_budget = 200000000;

struct pp_kept_beam {
    struct pp_stop stop;
    struct pp_beam *beam; /* NULL: not created yet */
    struct pp_beam_space space;
    int count, places;
    struct known_areas *table;
    int mean_count;
    struct kept_means {
        struct pp_glass glass;
        double values[2];
    } means[GLASSES];
};

struct pp_beams {
    const struct pp_world *world;
    bool plain;
    struct pp_kept_beam *list; /* for each opening: without and with obstructions
                                * outside */
};

enum pp_status pp_beams_create(struct pp_beams **made, const struct pp_world *world,
                               bool plain, struct pp_error *err)
{
    struct pp_beams *beams = calloc(1, sizeof *beams);
    *made = NULL;
    if (!beams)
        return pp_fail_memory(err);
    beams->world = world;
    beams->plain = plain;
    beams->list = calloc(2 * (size_t)world->opening_count + 1, sizeof *beams->list);
    if (!beams->list) {
        free(beams);
        return pp_fail_memory(err);
    }
    *made = beams;
    return PP_OK;
}

void pp_beams_stop_when(struct pp_beams *beams, struct pp_stop stop)
{
    for (int i = 0; i < 2 * beams->world->opening_count; i++)
        beams->list[i].stop = stop;
}

void pp_beams_destroy(struct pp_beams *beams)
{
    if (!beams)
        return;
    for (int i = 0; i < 2 * beams->world->opening_count; i++) {
        pp_beam_destroy(beams->list[i].beam);
        pp_beam_space_clear(&beams->list[i].space);
        free(beams->list[i].table);
    }
    free(beams->list);
    free(beams);
}

const struct pp_world *pp_beams_world(const struct pp_beams *beams)
{
    return beams->world;
}

bool pp_beams_plain(const struct pp_beams *beams)
{
    return beams->plain;
}

enum pp_status pp_beams_of(struct pp_kept_beam **kept, struct pp_beams *beams,
                           const struct pp_opening *opening, bool with_outside,
                           struct pp_error *err)
{
    *kept = &beams->list[2 * (opening - beams->world->openings) + with_outside];
    return (*kept)->beam ? PP_OK
                         : pp_beam_create(&(*kept)->beam, beams->world, opening,
                                          with_outside, err);
}

/* ---- the table ---- */

/* The direction's slot in the table, or the free slot where it belongs. */
static struct known_areas *known_areas_slot(struct known_areas *table, int places,
                                            double x, double y)
{
    double xy[2] = {x, y};
    uint64_t bits[2];
    memcpy(bits, xy, sizeof bits);
    uint64_t mixed = (bits[0] ^ bits[1] >> 29) * UINT64_C(0x9e3779b97f4a7c15);
    mixed = (mixed ^ mixed >> 32 ^ bits[1]) * UINT64_C(0xd6e8feb86659fd93);
    uint64_t at = mixed >> 32;
    while (at &= (uint64_t)places - 1,
           !isinf(table[at].x) && !(table[at].x == x && table[at].y == y))
        at++;
    return &table[at];
}

/* Doubles the table, or creates it; if memory runs out, the table stays as it is. */
static void grow_known_areas(struct pp_kept_beam *kept)
{
    int places = kept->places > 0 ? 2 * kept->places : FIRST;
    struct known_areas *table = malloc((size_t)places * sizeof *table);
    if (!table)
        return;
    for (int i = 0; i < places; i++)
        table[i].x = INFINITY;
    for (int i = 0; i < kept->places; i++)
        if (!isinf(kept->table[i].x))
            *known_areas_slot(table, places, kept->table[i].x, kept->table[i].y) =
                kept->table[i];
    free(kept->table);
    kept->table = table;
    kept->places = places;
}

bool pp_beams_gave_up(const struct pp_beams *beams)
{
    for (int i = 0; i < 2 * beams->world->opening_count; i++)
        if (pp_beam_budget_exhausted(&beams->list[i].space))
            return true;
    return false;
}

enum pp_status pp_kept_beam_areas(struct pp_beam_areas *areas,
                                  struct pp_kept_beam *kept, struct pp_vec3 u,
                                  struct pp_error *err)
{
    *areas = (struct pp_beam_areas){0};
    if (pp_stop_check(kept->stop, err) != PP_OK)
        return PP_INTERRUPTED;
    kept->space.work_budget = work_budget;
    if (pp_beam_budget_exhausted(&kept->space))
        return PP_OK;
    if (2 * kept->count >= kept->places && kept->places < MOST)
        grow_known_areas(kept);
    struct known_areas *known =
        kept->places > 0 ? known_areas_slot(kept->table, kept->places, u.x, u.y) : NULL;
    if (known && !isinf(known->x)) {
        *areas = known->areas;
        return PP_OK;
    }
    enum pp_status status = pp_beam_areas(areas, kept->beam, &kept->space, u, err);
    if (status == PP_OK && 2 * kept->count < kept->places) {
        *known = (struct known_areas){u.x, u.y, *areas};
        kept->count++;
    }
    return status;
}

/* ---- means ---- */

bool pp_kept_beam_means(double means[2], const struct pp_kept_beam *kept,
                        const struct pp_glass *glass)
{
    for (int i = 0; i < kept->mean_count; i++)
        if (pp_glass_is_same(&kept->means[i].glass, glass)) {
            memcpy(means, kept->means[i].values, sizeof kept->means[i].values);
            return true;
        }
    return false;
}

void pp_kept_beam_keep_means(struct pp_kept_beam *kept, const struct pp_glass *glass,
                             const double means[2])
{
    if (kept->mean_count == GLASSES)
        return;
    struct kept_means *next = &kept->means[kept->mean_count++];
    next->glass = *glass;
    memcpy(next->values, means, sizeof next->values);
}
