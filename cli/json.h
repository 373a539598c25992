/* json.h - the small words that every JSON of the program is put together with.
 *
 * Each adds to an object and answers false when memory is out; a chain of && then is
 * the object.
 */
#ifndef PP_CLI_JSON_H
#define PP_CLI_JSON_H

#include <json.h>
#include <stdbool.h>

enum { PP_JSON_STYLE = JSON_C_TO_STRING_SPACED | JSON_C_TO_STRING_NOSLASHESCAPE };

/* `value` is handed over, whether it could be added or not; NULL is want of memory. */
bool pp_json_add(struct json_object *object, const char *key,
                 struct json_object *value);

/* Ten significant digits; what is not finite is null. */
bool pp_json_number(struct json_object *object, const char *key, double number);

/* Bytes that are no UTF-8 are replaced; NULL is null. */
bool pp_json_text(struct json_object *object, const char *key, const char *text);

/* The object is printed on one line, within one that is printed over many. */
void pp_json_on_one_line(struct json_object *object);

#endif
