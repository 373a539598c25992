/* json.h - the small words that every JSON of the program is put together with.
 *
 * Each adds to an object and answers false when memory is out; a chain of && then is
 * the object.
 */
#ifndef PP_REPORTS_PARTS_JSON_H
#define PP_REPORTS_PARTS_JSON_H

#include <json.h>
#include <stdbool.h>
#include <stdio.h>

#include "model/base/error.h"

enum { PP_JSON_STYLE = JSON_C_TO_STRING_SPACED | JSON_C_TO_STRING_NOSLASHESCAPE };

/* `value` is handed over, whether it could be added or not; NULL is want of memory. */
bool pp_json_add(struct json_object *object, const char *key,
                 struct json_object *value);

/* Adds a number of ten significant digits; null if it is not finite. */
bool pp_json_number(struct json_object *object, const char *key, double number);

/* Returns the object if it is complete; otherwise frees it and returns NULL. */
struct json_object *pp_json_whole(struct json_object *object, bool good);

/* Appends `value` to an array and takes ownership of it, as above. */
bool pp_json_append(struct json_object *array, struct json_object *value);

/* An array of numbers, each as above, on one line. */
bool pp_json_numbers(struct json_object *object, const char *key, const double *numbers,
                     int count);

/* Bytes that are no UTF-8 are replaced; NULL is null. */
bool pp_json_text(struct json_object *object, const char *key, const char *text);

struct pp_study_options;

/* Adds "simulation": how it was stopped, so that it can be done again. by_clock: the
 * time was over first. */
bool pp_json_simulation(struct json_object *object,
                        const struct pp_study_options *options, bool by_clock);

struct pp_mistakes;

/* Adds "warnings", a list of texts with their lines, if there are any; NULL is none. */
bool pp_json_warnings(struct json_object *object, const struct pp_mistakes *doubts);

/* Prints an object over many lines, and frees it; NULL: memory is out. */
enum pp_status pp_json_print(FILE *out, struct json_object *object,
                             struct pp_error *err);

/* Makes the object of one room, by its number; NULL: memory is out. */
typedef struct json_object *pp_json_room(const void *all, int index);

/* Prints the object of the one room, or with `several` an array of all. */
enum pp_status pp_json_print_rooms(FILE *out, pp_json_room *room, const void *all,
                                   int count, bool several, struct pp_error *err);

/* The object is printed on one line, within one that is printed over many. */
void pp_json_on_one_line(struct json_object *object);

#endif
