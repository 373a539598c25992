/* traced_rooms.h - a file of rooms with their traced values: for the fit of formulae,
 * and for its test on held-out rooms.
 *
 *     # comment
 *     room NUMBER
 *     <room ...> ... </room>          its room file, on one or more lines
 *     INDEX IRC ERROR DF              one of its points, by index; -1: the average
 *
 * IRC, its standard error and DF are fractions. bench/sample_atlas.sh makes such a file
 * from an atlas.
 */
#ifndef PP_TESTS_LIB_TRACED_ROOMS_H
#define PP_TESTS_LIB_TRACED_ROOMS_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/lib/room_of.h"

enum { PP_TRACED_POINTS = 64 };

struct pp_traced_point {
    int index; /* index into the world's receivers; -1: the average */
    double irc, std_error, df;
    bool dark; /* in the darkest quarter of the room's points, by df */
};

struct pp_traced_room {
    int number;
    struct pp_world *world;
    struct pp_outside_light light;
    int count; /* number of points, including the average */
    struct pp_traced_point points[PP_TRACED_POINTS];
};

/* Marks the darkest quarter, rounded up. */
static inline void pp_traced_rooms_mark(struct pp_traced_room *room)
{
    int points = 0;
    for (int i = 0; i < room->count; i++)
        points += room->points[i].index >= 0;
    for (int i = 0; i < room->count; i++) {
        int darker = 0;
        for (int k = 0; k < room->count; k++)
            darker +=
                room->points[k].index >= 0 && room->points[k].df < room->points[i].df;
        room->points[i].dark = room->points[i].index >= 0 && 4 * darker < points;
    }
}

/* Reads the next room; false at the end of the file. The caller destroys its world. */
static inline bool pp_traced_rooms_next(FILE *in, struct pp_traced_room *room)
{
    static const struct pp_traced_room none;
    char line[2000], xml[16384] = "";
    *room = none;
    do
        if (!fgets(line, sizeof line, in))
            return false;
    while (sscanf(line, "room %d", &room->number) != 1);
    while (fgets(line, sizeof line, in)) {
        assert_true(strlen(xml) + strlen(line) < sizeof xml);
        strcat(xml, line);
        if (strstr(line, "</room>"))
            break;
    }
    room->world = pp_test_lit_world(&room->light, xml);
    long start = ftell(in);
    while (fgets(line, sizeof line, in) && room->count < PP_TRACED_POINTS) {
        struct pp_traced_point *point = room->points + room->count;
        int read = sscanf(line, "%d %lf %lf %lf", &point->index, &point->irc,
                          &point->std_error, &point->df);
        if (read == 4)
            room->count++;
        else if (strncmp(line, "room", 4) == 0)
            break;
        start = ftell(in);
    }
    fseek(in, start, SEEK_SET);
    pp_traced_rooms_mark(room);
    return true;
}

#endif
