/* json.h - functions that build all JSON output of the program.
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

/* Adds `value`, and takes ownership of it even if it could not be added. value NULL:
 * treated as out of memory. */
bool pp_json_add(struct json_object *object, const char *key,
                 struct json_object *value);

/* Adds a number with ten significant digits, or null if it is not finite. */
bool pp_json_number(struct json_object *object, const char *key, double number);

/* Returns the object if `good` is true. Otherwise frees the object and returns NULL. */
struct json_object *pp_json_whole(struct json_object *object, bool good);

/* Appends `value` to an array, and takes ownership of it even after a failure. */
bool pp_json_append(struct json_object *array, struct json_object *value);

/* Adds an array of numbers on one line. Each number is written as by pp_json_number. */
bool pp_json_numbers(struct json_object *object, const char *key, const double *numbers,
                     int count);

/* Adds a text, or null for NULL. Bytes that are not UTF-8 are replaced. */
bool pp_json_text(struct json_object *object, const char *key, const char *text);

struct pp_study_options;

/* Adds "simulation": the conditions that end it, so that the simulation can be
 * repeated. by_clock: the time limit ended the simulation. */
bool pp_json_simulation(struct json_object *object,
                        const struct pp_study_options *options, bool by_clock);

struct pp_mistakes;

/* Adds "warnings", a list of texts with line numbers, if there are any. doubts NULL:
 * there are none. */
bool pp_json_warnings(struct json_object *object, const struct pp_mistakes *doubts);

/* Prints an object on several lines, and frees the object. object NULL: out of
 * memory. */
enum pp_status pp_json_print(FILE *out, struct json_object *object,
                             struct pp_error *err);

/* Function that makes the object of the room with that index. NULL: out of memory. */
typedef struct json_object *pp_json_room(const void *all, int index);

/* Prints the object of the only room or, if `several` is set, an array of all
 * objects. */
enum pp_status pp_json_print_rooms(FILE *out, pp_json_room *room, const void *all,
                                   int count, bool several, struct pp_error *err);

/* Marks an object to be printed on one line within an object that is printed on
 * several. */
void pp_json_on_one_line(struct json_object *object);

#endif
