/* other_values.h - another program's values at points, as CSV.
 *
 * The first line has the names of the columns, in any order, separated by commas,
 * semicolons or tabs: x, y and z (m, the room's own coordinates; without z the points
 * are on the working plane), nx, ny and nz (without them the points face up), and one
 * column of values, whose name gives the unit:
 *
 *     df_percent, value_percent, percent, df_%, df [%], daylight factor [%]
 *     df_fraction, fraction
 *     lux, lx, illuminance, illuminance_lx, e_lx, e [lx], illuminance [lx]
 *     df, daylight_factor, value          the unit is given by the user
 *
 * The units m, % and lx may also be in parentheses: "x [m]" or "x (m)". A file that
 * begins with a number has no header, and one value per line. If semicolons or tabs
 * separate the columns, a comma is a decimal comma.
 *
 * The columns label, name, point and id are ignored. Without x and y the values belong
 * to the room's own points, in their order. Empty lines and lines that begin with "#"
 * are ignored.
 */
#ifndef PP_CLI_COMPARE_OTHER_VALUES_H
#define PP_CLI_COMPARE_OTHER_VALUES_H

#include "studies/study_room.h"

enum pp_other_unit {
    PP_OTHER_UNKNOWN,
    PP_OTHER_PERCENT,
    PP_OTHER_FRACTION,
    PP_OTHER_LUX
};

struct pp_other_value {
    struct pp_vec3 place; /* z NAN: on the working plane */
    struct pp_vec3 normal;
    double value; /* value in the unit of the file, 0 or more */
    int line;
};

struct pp_other_values {
    struct pp_other_value *list;
    int count;
    bool has_places;
    enum pp_other_unit unit; /* unit given by the header; unknown if the header does not
                              * name one */
};

/* Reads the file. PP_BAD_INPUT if it is invalid; the message states file, line and
 * reason. */
enum pp_status pp_other_values_read(struct pp_other_values *values, const char *path,
                                    struct pp_error *err);
void pp_other_values_clear(struct pp_other_values *values);

/* Replaces the room's points by the points of the values, or by an evenly spread subset
 * if there are more than `most`. *chosen, freed by the caller, gets the index of the
 * value for each of the room->receiver_count points. */
enum pp_status pp_other_values_place(int **chosen, struct pp_study_room *room,
                                     const struct pp_other_values *values,
                                     const char *path, int most, struct pp_error *err);

/* Index of the value that belongs to point number `point` of an evenly spread subset:
 * `kept` of `count` values. The subset contains the first value. */
int pp_other_values_spread(int point, int count, int kept);

#endif
