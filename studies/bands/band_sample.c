/* band_sample.c - quantiles and fractions of a sample in which each room has a total
 * weight of 1. */
#include "studies/bands/band_sample.h"

#include <math.h>
#include <stdlib.h>

struct weighted {
    double ratio, weight;
};

static int compare_sampled_ratios(const void *a, const void *b)
{
    const struct weighted *x = a, *y = b;
    return (x->ratio > y->ratio) - (x->ratio < y->ratio);
}

/* Index in `rows` after the last row of the room to which row `first` belongs. */
static int room_end(const struct pp_band_sample *sample, const int *rows, int count,
                    int first)
{
    int end = first + 1;
    while (end < count && sample->rooms[rows[end]] == sample->rooms[rows[first]])
        end++;
    return end;
}

int pp_band_sample_rooms(const struct pp_band_sample *sample, const int *rows,
                         int count)
{
    int rooms = 0;
    for (int i = 0; i < count; i = room_end(sample, rows, count, i))
        rooms++;
    return rooms;
}

/* Quantile p of the ratios. The cumulative weight of a ratio includes half of its own
 * weight; values between ratios are interpolated linearly. list: in ascending order;
 * total: sum of the weights. */
static double quantile(const struct weighted *list, int count, double total, double p)
{
    double wanted = p * total, below = 0.0, last = 0.0;
    for (int i = 0; i < count; i++) {
        double here = below + 0.5 * list[i].weight;
        if (here >= wanted) {
            if (i == 0)
                return list[0].ratio;
            double t = (wanted - last) / (here - last);
            return list[i - 1].ratio + t * (list[i].ratio - list[i - 1].ratio);
        }
        below += list[i].weight;
        last = here;
    }
    return list[count - 1].ratio;
}

/* Ratios of the rows in ascending order, with their weights. The caller frees the list.
 * NULL: out of memory. *rooms is set to the number of rooms. */
static struct weighted *sorted(const struct pp_band_sample *sample, const int *rows,
                               int count, int *rooms)
{
    struct weighted *list = malloc((size_t)count * sizeof *list);
    *rooms = 0;
    for (int i = 0, end; list && i < count; i = end) {
        end = room_end(sample, rows, count, i);
        for (int k = i; k < end; k++)
            list[k] = (struct weighted){sample->ratios[rows[k]], 1.0 / (end - i)};
        ++*rooms;
    }
    if (list)
        qsort(list, (size_t)count, sizeof *list, compare_sampled_ratios);
    return list;
}

enum pp_status pp_band_sample_quantiles(struct pp_band_quantiles *quantiles,
                                        const struct pp_band_sample *sample,
                                        const int *rows, int count,
                                        struct pp_error *err)
{
    int rooms;
    struct weighted *list = sorted(sample, rows, count, &rooms);
    if (!list)
        return pp_fail_memory(err);
    /* The cumulative fraction of rank r among n rooms is (r - 1/2) / n. */
    double tail = fmax((0.025 * (rooms + 1) - 0.5) / rooms, 0.0);
    *quantiles = (struct pp_band_quantiles){quantile(list, count, rooms, tail),
                                            quantile(list, count, rooms, 0.5),
                                            quantile(list, count, rooms, 1.0 - tail)};
    free(list);
    return PP_OK;
}

enum pp_status pp_band_sample_spread(double *spread,
                                     const struct pp_band_sample *sample,
                                     const int *rows, int count, struct pp_error *err)
{
    int rooms;
    struct weighted *list = sorted(sample, rows, count, &rooms);
    if (!list)
        return pp_fail_memory(err);
    *spread =
        0.5 * (quantile(list, count, rooms, 0.84) - quantile(list, count, rooms, 0.16));
    free(list);
    return PP_OK;
}

double pp_band_sample_inside(const struct pp_band_sample *sample, const int *rows,
                             int count, const struct pp_band_quantiles *band, bool ends)
{
    double inside = 0.0;
    int rooms = 0;
    for (int i = 0, end; i < count; i = end) {
        end = room_end(sample, rows, count, i);
        int in = 0;
        for (int k = i; k < end; k++) {
            double ratio = sample->ratios[rows[k]];
            in += ends ? ratio >= band->low && ratio <= band->high
                       : ratio > band->low && ratio < band->high;
        }
        inside += (double)in / (end - i);
        rooms++;
    }
    return rooms > 0 ? inside / rooms : NAN;
}
