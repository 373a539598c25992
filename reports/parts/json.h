/* json.h - functions from which all JSON of the program is built.
 *
 * Functions that add to an object return false if memory runs out, so that calls can be
 * chained by &&.
 */
#ifndef PP_REPORTS_PARTS_JSON_H
#define PP_REPORTS_PARTS_JSON_H

#include <json.h>
#include <stdbool.h>
#include <stdio.h>

#include "model/base/error.h"

enum { PP_JSON_STYLE = JSON_C_TO_STRING_SPACED | JSON_C_TO_STRING_NOSLASHESCAPE };

/* Takes ownership of `value`, whether it could be added or not; NULL counts as out of
 * memory. */
bool pp_json_add(struct json_object *object, const char *key,
                 struct json_object *value);

/* Adds a number with ten significant digits; null if it is not finite. */
bool pp_json_number(struct json_object *object, const char *key, double number);

/* Returns the object if it is complete; otherwise frees it and returns NULL. */
struct json_object *pp_json_whole(struct json_object *object, bool good);

/* Appends `value` to an array, and takes ownership of it like pp_json_add. */
bool pp_json_append(struct json_object *array, struct json_object *value);

/* Adds an array of numbers, each as by pp_json_number, on one line. */
bool pp_json_numbers(struct json_object *object, const char *key, const double *numbers,
                     int count);

/* Adds a text; replaces bytes that are not UTF-8; NULL becomes null. */
bool pp_json_text(struct json_object *object, const char *key, const char *text);

struct pp_study_options;

/* Adds "simulation": the stop conditions, so that the simulation can be repeated.
 * by_clock: the time limit ended it. */
bool pp_json_simulation(struct json_object *object,
                        const struct pp_study_options *options, bool by_clock);

struct pp_mistakes;

/* Adds "warnings", a list of texts with their lines, if there are any; doubts NULL:
 * none. */
bool pp_json_warnings(struct json_object *object, const struct pp_mistakes *doubts);

/* Prints an object on several lines, and frees it; NULL: out of memory. */
enum pp_status pp_json_print(FILE *out, struct json_object *object,
                             struct pp_error *err);

/* Makes the object of one room, by its index; NULL: out of memory. */
typedef struct json_object *pp_json_room(const void *all, int index);

/* Prints the object of the only room, or with `several` an array of all. */
enum pp_status pp_json_print_rooms(FILE *out, pp_json_room *room, const void *all,
                                   int count, bool several, struct pp_error *err);

/* Marks the object to be printed on one line, inside one that is printed on several. */
void pp_json_on_one_line(struct json_object *object);

#endif
