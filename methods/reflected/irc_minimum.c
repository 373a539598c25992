/* irc_minimum.c - the printed tables, their ranges, and interpolation in them. */
#include "methods/reflected/irc_minimum.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#include "methods/interpolate.h"

enum { FLOORS = 3, WALLS = 4, COLUMNS = 1 + FLOORS * WALLS };

/* ratio of glass to floor area, then the minimum for each floor and wall reflectance,
 * all in per cent */
static const double printed[][COLUMNS] = {
#include "tables/irc_minimum.inc"
};

/* per row: reflectance of the walls (per cent); average divided by minimum; factors for
 * floors of 10 m2 and 90 m2 */
static const double by_walls[WALLS][4] = {
#include "tables/irc_minimum_walls.inc"
};

/* reflectance of the ceiling (per cent); its factor */
static const double by_ceiling[][2] = {
#include "tables/irc_minimum_ceiling.inc"
};

/* reflectances of the floor (per cent), in the order of the columns of `printed` */
static const double by_floor[FLOORS] = {10.0, 20.0, 40.0};

enum {
    ROWS = sizeof printed / sizeof *printed,
    CEILINGS = sizeof by_ceiling / sizeof *by_ceiling,
};

static const double small_floor_m2 = 10.0, floor_m2 = 40.0, large_floor_m2 = 90.0;

static double reflectance_between(double low, double high, double share)
{
    return low + share * (high - low);
}

/* True if the value is within the printed range, up to rounding. */
static bool covers(double low, double high, double value)
{
    double grain = 1e-9 * high;
    return value >= low - grain && value <= high + grain;
}

const char *pp_irc_minimum_lacks(const struct pp_irc_minimum_entry *entry)
{
    if (!covers(small_floor_m2, large_floor_m2, entry->floor_m2))
        return "the table covers floors of 10 to 90 m2 only";
    if (!covers(by_floor[0], by_floor[FLOORS - 1], 100.0 * entry->floor))
        return "the table covers floor reflectances of 0.1 to 0.4 only";
    if (!covers(by_walls[0][0], by_walls[WALLS - 1][0], 100.0 * entry->walls))
        return "the table covers wall reflectances of 0.2 to 0.8 only";
    if (!covers(by_ceiling[0][0], by_ceiling[CEILINGS - 1][0], 100.0 * entry->ceiling))
        return "the table covers ceiling reflectances of 0.4 to 0.8 only";
    if (!covers(0.0, printed[ROWS - 1][0], 100.0 * entry->glass_m2 / entry->floor_m2))
        return "the table covers glass areas up to half the floor area only";
    return NULL;
}

/* The minimum of one row, interpolated to the room's reflectances. */
static double read_irc_row(const double row[COLUMNS], int floor, double floor_share,
                           int walls, double walls_share)
{
    double at[2];
    for (int i = 0; i < 2; i++) {
        const double *cells = row + 1 + (floor - 1 + i) * WALLS;
        at[i] = reflectance_between(cells[walls - 1], cells[walls], walls_share);
    }
    return reflectance_between(at[0], at[1], floor_share);
}

/* The factor is 1 for 40 m2, and linear in the square root of the area between the
 * three sizes. */
static double floor_factor(double area_m2, const double factors[2])
{
    const double line[3][2] = {{sqrt(small_floor_m2), factors[0]},
                               {sqrt(floor_m2), 1.0},
                               {sqrt(large_floor_m2), factors[1]}};
    return pp_interpolate_linear(line, 3, sqrt(area_m2));
}

struct pp_irc_minimum pp_irc_minimum_read(const struct pp_irc_minimum_entry *entry)
{
    double glass_share, floor_share, walls_share;
    double percent = 100.0 * entry->glass_m2 / entry->floor_m2;
    int floor = pp_interpolate_interval(by_floor, FLOORS, 1, 0, 100.0 * entry->floor,
                                        &floor_share);
    int walls = pp_interpolate_interval(&by_walls[0][0], WALLS, 4, 0,
                                        100.0 * entry->walls, &walls_share);
    int row = pp_interpolate_interval(&printed[0][0], ROWS, COLUMNS, 0, percent,
                                      &glass_share);
    double low = read_irc_row(printed[row - 1], floor, floor_share, walls, walls_share);
    double high = read_irc_row(printed[row], floor, floor_share, walls, walls_share);
    double value = reflectance_between(low, high, glass_share);
    if (percent < printed[0][0])
        value = low * percent / printed[0][0];

    const double *dark = by_walls[walls - 1], *light = by_walls[walls];
    const double factors[2] = {reflectance_between(dark[2], light[2], walls_share),
                               reflectance_between(dark[3], light[3], walls_share)};
    return (struct pp_irc_minimum){
        .printed = value / 100.0,
        .floor_factor = floor_factor(entry->floor_m2, factors),
        .ceiling_factor =
            pp_interpolate_linear(by_ceiling, CEILINGS, 100.0 * entry->ceiling)};
}

double pp_irc_minimum_average_ratio(double walls)
{
    double share;
    int upper =
        pp_interpolate_interval(&by_walls[0][0], WALLS, 4, 0, 100.0 * walls, &share);
    return reflectance_between(by_walls[upper - 1][1], by_walls[upper][1], share);
}
