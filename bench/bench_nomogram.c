/* bench_nomogram.c - deviation of `nomogram` from `bre` in 1,000 random side-lit rooms,
 * in per cent.
 *
 * The last two columns contain the RMS deviation due to the rule R_cw = k R_fw and that
 * due to reading the scales.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/bench.h"
#include "methods/reflected/bre_terms.h"
#include "methods/method.h"
#include "methods/nomogram/nomogram_scale.h"
#include "simulate/sampling/hash.h"

enum { ROOMS = 1000 };

static double draw(uint64_t *series, double low, double high)
{
    *series = pp_hash(*series, 1);
    return low + (high - low) * (double)(*series >> 11) * 0x1p-53;
}

struct room {
    struct pp_world *world;
    struct pp_outside_light light;
    double floor, walls, ceiling, angle_deg;
    int windows;
};

/* Random box rooms with sides of 2.5 to 8 m. Reflectances: floor 0.1 to 0.5, walls 0.2
 * to 0.8, ceiling 0.3 to 0.9. One to three walls have a window. In half of the rooms
 * these walls have a skyline of 5 to 60 degrees. */
static struct room random_room(uint64_t number)
{
    static const char *const names[] = {"south", "east", "north", "west"};
    uint64_t series = pp_hash(314159, number);
    double width = draw(&series, 2.5, 8.0), depth = draw(&series, 2.5, 8.0);
    double height = draw(&series, 2.3, 4.0);
    struct room room = {0};
    room.floor = draw(&series, 0.1, 0.5);
    room.walls = draw(&series, 0.2, 0.8);
    room.ceiling = draw(&series, 0.3, 0.9);
    room.windows = (int)draw(&series, 1.0, 4.0);
    int first = (int)draw(&series, 0.0, 4.0);
    bool obstructed = draw(&series, 0.0, 1.0) < 0.5;
    room.angle_deg = obstructed ? draw(&series, 5.0, 60.0) : 0.0;
    char xml[4096];
    int n = snprintf(xml, sizeof xml,
                     "<room version='1'><plan width='%.3f' depth='%.3f' height='%.3f'/>"
                     "<finishes floor='%.3f' walls='%.3f' ceiling='%.3f'/>",
                     width, depth, height, room.floor, room.walls, room.ceiling);
    for (int i = 0; i < room.windows; i++) {
        int wall = (first + i) % 4;
        double length = wall % 2 ? depth : width;
        double wide = draw(&series, 0.3, 0.9) * length;
        double left = draw(&series, 0.05, 0.95) * (length - wide);
        double sill = draw(&series, 0.1, 0.5) * height;
        double high = draw(&series, 0.3, 0.9) * (height - sill);
        n += snprintf(xml + n, sizeof xml - (size_t)n,
                      "<window wall='%s' left='%.3f' sill='%.3f' width='%.3f' "
                      "height='%.3f'/>",
                      names[wall], left, sill, wide, high);
        if (obstructed)
            n += snprintf(xml + n, sizeof xml - (size_t)n,
                          "<skyline wall='%s' angle='%.2f'/>", names[wall],
                          room.angle_deg);
    }
    snprintf(xml + n, sizeof xml - (size_t)n, "</room>");
    room.world = world_of(&room.light, xml);
    return room;
}

/* Three values: by the formula, by the formula with the rule, and as read from the
 * nomogram. */
static bool values_of(const struct pp_world *world,
                      const struct pp_outside_light *light, double values[3])
{
    const struct pp_method *method = &pp_method_nomogram;
    void *tools;
    if (method->refuses_room(world, light, NULL)
        || method->prepare(&tools, world, light, NULL) != PP_OK)
        return false;
    values[0] = values[1] = values[2] = 0.0;
    bool done = true;
    for (int i = 0; i < world->opening_count && done; i++) {
        struct pp_bre_terms terms;
        struct pp_part part = {0};
        done = pp_bre_terms(&terms, world, light, &world->openings[i], NULL) == PP_OK
               && method->evaluate(world, light, &world->openings[i], NULL, tools,
                                   &part, NULL)
                      == PP_OK;
        values[0] += pp_bre_terms_average(&terms);
        values[2] += part.value;
        terms.R_fw = 2.0 / (1.0 + PP_NOMOGRAM_K) * terms.all.reflectance;
        terms.R_cw = PP_NOMOGRAM_K * terms.R_fw;
        values[1] += pp_bre_terms_average(&terms);
    }
    method->destroy_tools(tools);
    return done;
}

static int ascending(const void *a, const void *b)
{
    double difference = *(const double *)a - *(const double *)b;
    return (difference > 0.0) - (difference < 0.0);
}

/* Prints a row of the table: deviations in `count` rooms, per cent. */
static void print_row(const char *name, double *rule, double *read, int count)
{
    double sum = 0.0, squares = 0.0, rule_squares = 0.0, reading_squares = 0.0;
    for (int i = 0; i < count; i++) {
        double reading = ((100.0 + read[i]) / (100.0 + rule[i]) - 1.0) * 100.0;
        sum += read[i] / count;
        squares += read[i] * read[i] / count;
        rule_squares += rule[i] * rule[i] / count;
        reading_squares += reading * reading / count;
    }
    qsort(read, (size_t)count, sizeof *read, ascending);
    printf("| %s | %d | %.1f | %.1f | %.1f to %.1f | %.1f to %.1f | %.1f | %.1f |\n",
           name, count, sum, sqrt(squares), read[(int)(0.05 * count)],
           read[(int)(0.95 * count)], read[0], read[count - 1], sqrt(rule_squares),
           sqrt(reading_squares));
}

static bool all_rooms(const struct room *room)
{
    (void)room;
    return true;
}

static bool open_rooms(const struct room *room)
{
    return room->angle_deg == 0.0;
}

static bool obstructed_rooms(const struct room *room)
{
    return room->angle_deg > 0.0;
}

static bool dark_floors(const struct room *room)
{
    return room->floor < 0.2;
}

static bool light_floors(const struct room *room)
{
    return room->floor > 0.4;
}

static bool ordinary_rooms(const struct room *room)
{
    return room->floor < 0.3 && room->walls > 0.4 && room->walls < 0.6
           && room->ceiling > 0.6;
}

static bool one_window(const struct room *room)
{
    return room->windows == 1;
}

static bool three_windows(const struct room *room)
{
    return room->windows == 3;
}

int main(void)
{
    static const struct {
        const char *name;
        bool (*holds)(const struct room *room);
    } rows[] = {
        {"all", all_rooms},
        {"without obstruction", open_rooms},
        {"obstruction 5\u00b0 to 60\u00b0", obstructed_rooms},
        {"window in one wall", one_window},
        {"windows in three walls", three_windows},
        {"floor below 0.2", dark_floors},
        {"floor above 0.4", light_floors},
        {"floor below 0.3, walls 0.4 to 0.6, ceiling above 0.6", ordinary_rooms}};
    enum { ROWS = sizeof rows / sizeof rows[0] };
    static double rule[ROWS][ROOMS], read[ROWS][ROOMS];
    int counts[ROWS] = {0};
    for (int i = 0; i < ROOMS; i++) {
        struct room room = random_room((uint64_t)i);
        double values[3];
        if (!room.world || !values_of(room.world, &room.light, values)) {
            printf("room %d cannot be worked out\n", i);
            return 1;
        }
        for (int k = 0; k < ROWS; k++) {
            if (!rows[k].holds(&room))
                continue;
            rule[k][counts[k]] = 100.0 * (values[1] / values[0] - 1.0);
            read[k][counts[k]++] = 100.0 * (values[2] / values[0] - 1.0);
        }
        pp_world_destroy(room.world);
    }
    printf(
        "nomogram over bre, per cent\n\n| rooms | number | mean | rms | 5 to 95 %% of "
        "the rooms | extremes | of the rule, rms | of the reading, rms |\n| --- | --- "
        "| "
        "--- | --- | --- | --- | --- | --- |\n");
    for (int k = 0; k < ROWS; k++)
        print_row(rows[k].name, rule[k], read[k], counts[k]);
    return 0;
}
