/* lattice.c - sorts the coordinates of the receivers into columns and rows. */
#include "model/results/lattice.h"

#include <math.h>
#include <stdlib.h>

/* same_m: coordinates that differ by less than this (m) count as equal. even: so do
 * steps whose relative difference is smaller than this. */
static const double same_m = 1e-6, even = 1e-3;

static int compare_coordinates(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Sorts the values and removes duplicates; returns the number left. */
static int distinct(double *values, int count)
{
    int kept = 0;
    qsort(values, (size_t)count, sizeof *values, compare_coordinates);
    for (int i = 0; i < count; i++)
        if (kept == 0 || values[i] - values[kept - 1] > same_m)
            values[kept++] = values[i];
    return kept;
}

/* True if all steps are integer multiples of the smallest one. */
static bool is_even(const double *values, int count)
{
    double least = INFINITY;
    for (int i = 1; i < count; i++)
        least = fmin(least, values[i] - values[i - 1]);
    for (int i = 1; i < count; i++) {
        double steps = (values[i] - values[i - 1]) / least;
        if (fabs(steps - round(steps)) > even * steps)
            return false;
    }
    return count >= 2;
}

static int lattice_index(const double *values, int count, double value)
{
    int low = 0, high = count - 1;
    while (low < high) {
        int middle = (low + high) / 2;
        if (values[middle] < value - 0.5 * same_m)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static bool faces_up_at_one_height(const struct pp_receiver *receivers, int count)
{
    for (int i = 0; i < count; i++)
        if (receivers[i].normal.z < 1.0 - 1e-9
            || fabs(receivers[i].position.z - receivers[0].position.z) > same_m)
            return false;
    return count >= 4;
}

/* Returns false if two receivers have the same position. */
static bool settle_lattice(struct pp_lattice *lattice,
                           const struct pp_receiver *receivers, int count)
{
    for (int i = 0; i < lattice->columns * lattice->rows; i++)
        lattice->receivers[i] = -1;
    for (int i = 0; i < count; i++) {
        int *cell = &lattice->receivers[lattice_index(lattice->y, lattice->rows,
                                                      receivers[i].position.y)
                                            * lattice->columns
                                        + lattice_index(lattice->x, lattice->columns,
                                                        receivers[i].position.x)];
        if (*cell >= 0)
            return false;
        *cell = i;
    }
    return true;
}

enum pp_status pp_lattice_find(struct pp_lattice *lattice,
                               const struct pp_receiver *receivers, int count,
                               struct pp_error *err)
{
    *lattice = (struct pp_lattice){0};
    if (!faces_up_at_one_height(receivers, count))
        return PP_OK;
    lattice->x = malloc((size_t)count * sizeof *lattice->x);
    lattice->y = malloc((size_t)count * sizeof *lattice->y);
    bool good = lattice->x && lattice->y;
    for (int i = 0; i < count && good; i++) {
        lattice->x[i] = receivers[i].position.x;
        lattice->y[i] = receivers[i].position.y;
    }
    if (good) {
        lattice->columns = distinct(lattice->x, count);
        lattice->rows = distinct(lattice->y, count);
    }
    bool is_one = good && is_even(lattice->x, lattice->columns)
                  && is_even(lattice->y, lattice->rows)
                  && 0.5 * lattice->columns * lattice->rows <= count;
    if (is_one) {
        size_t cells = (size_t)lattice->columns * (size_t)lattice->rows;
        lattice->receivers = malloc(cells * sizeof *lattice->receivers);
        good = lattice->receivers != NULL;
    }
    if (!good || !is_one || !settle_lattice(lattice, receivers, count))
        pp_lattice_clear(lattice);
    return good ? PP_OK : pp_fail_memory(err);
}

void pp_lattice_clear(struct pp_lattice *lattice)
{
    free(lattice->x);
    free(lattice->y);
    free(lattice->receivers);
    *lattice = (struct pp_lattice){0};
}
