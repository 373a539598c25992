/* light_sum.c - see light_sum.h. */
#include "simulate/research/radiosity/light_sum.h"

#include <stdlib.h>

#include "model/base/array.h"

void pp_light_sum_clear(struct pp_light_sum *sum)
{
    free(sum->terms);
    free(sum->hits);
    *sum = (struct pp_light_sum){.failed = false};
}

void pp_light_sum_add(struct pp_light_sum *sum, int source, enum pp_component part,
                      double weight)
{
    if (sum->failed
        || pp_array_reserve(&sum->terms, &sum->term_room, sum->term_count + 1,
                            sizeof *sum->terms, NULL)
               != PP_OK) {
        sum->failed = true;
        return;
    }
    sum->terms[sum->term_count++] = (struct pp_light_term){source, part, weight};
}

void pp_light_sum_hit(struct pp_light_sum *sum, int side, struct pp_vec3 point,
                      enum pp_component part, double weight)
{
    if (sum->failed
        || pp_array_reserve(&sum->hits, &sum->hit_room, sum->hit_count + 1,
                            sizeof *sum->hits, NULL)
               != PP_OK) {
        sum->failed = true;
        return;
    }
    sum->hits[sum->hit_count++] = (struct pp_outside_hit){side, point, part, weight};
}

struct pp_light_mark pp_light_sum_mark(const struct pp_light_sum *sum)
{
    struct pp_light_mark mark = {.term_count = sum->term_count,
                                 .hit_count = sum->hit_count};
    for (int i = 0; i < PP_LIGHT_PARTS; i++)
        mark.fixed[i] = sum->fixed[i];
    return mark;
}

void pp_light_sum_scale(struct pp_light_sum *sum, const struct pp_light_mark *from,
                        const struct pp_light_mark *to, double factor)
{
    for (int i = 0; i < PP_LIGHT_PARTS; i++)
        sum->fixed[i] += (factor - 1.0) * (to->fixed[i] - from->fixed[i]);
    for (int i = from->term_count; i < to->term_count; i++)
        sum->terms[i].weight *= factor;
    for (int i = from->hit_count; i < to->hit_count; i++)
        sum->hits[i].weight *= factor;
}

void pp_light_sum_tidy(struct pp_light_sum *sum)
{
    int terms = 0, hits = 0;
    for (int i = 0; i < sum->term_count; i++)
        if (sum->terms[i].weight != 0.0)
            sum->terms[terms++] = sum->terms[i];
    for (int i = 0; i < sum->hit_count; i++)
        if (sum->hits[i].weight != 0.0)
            sum->hits[hits++] = sum->hits[i];
    sum->term_count = terms;
    sum->hit_count = hits;
}
