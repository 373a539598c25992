/* json.c - adds numbers, texts and lists to objects of json-c, and prints them. */
#include "reports/parts/json.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/mistakes.h"
#include "studies/study_options.h"
#include "reports/parts/format.h"

bool pp_json_add(struct json_object *object, const char *key, struct json_object *value)
{
    if (value && json_object_object_add(object, key, value) == 0)
        return true;
    json_object_put(value);
    return false;
}

bool pp_json_append(struct json_object *array, struct json_object *value)
{
    if (value && array && json_object_array_add(array, value) == 0)
        return true;
    json_object_put(value);
    return false;
}

struct json_object *pp_json_whole(struct json_object *object, bool good)
{
    if (good)
        return object;
    json_object_put(object);
    return NULL;
}

static struct json_object *number_object(double number)
{
    char digits[40];
    snprintf(digits, sizeof digits, "%.10g", number + 0.0);
    return json_object_new_double_s(number, digits);
}

bool pp_json_number(struct json_object *object, const char *key, double number)
{
    if (!isfinite(number))
        return json_object_object_add(object, key, NULL) == 0;
    return pp_json_add(object, key, number_object(number));
}

bool pp_json_numbers(struct json_object *object, const char *key, const double *numbers,
                     int count)
{
    struct json_object *array = json_object_new_array();
    if (!pp_json_add(object, key, array))
        return false;
    pp_json_on_one_line(array);
    for (int i = 0; i < count; i++) {
        bool added = isfinite(numbers[i])
                         ? pp_json_append(array, number_object(numbers[i]))
                         : json_object_array_add(array, NULL) == 0;
        if (!added)
            return false;
    }
    return true;
}

bool pp_json_text(struct json_object *object, const char *key, const char *text)
{
    if (!text)
        return json_object_object_add(object, key, NULL) == 0;
    char *repaired = pp_format_utf8_repair(text);
    if (!repaired)
        return false;
    bool added = pp_json_add(object, key, json_object_new_string(repaired));
    free(repaired);
    return added;
}

static int print_on_one_line(struct json_object *object, struct printbuf *buffer,
                             int level, int flags)
{
    (void)level;
    (void)flags;
    json_object_set_serializer(object, NULL, NULL, NULL);
    const char *text = json_object_to_json_string_ext(object, PP_JSON_STYLE);
    return text ? printbuf_memappend(buffer, text, (int)strlen(text)) : -1;
}

void pp_json_on_one_line(struct json_object *object)
{
    json_object_set_serializer(object, print_on_one_line, NULL, NULL);
}

bool pp_json_simulation(struct json_object *object,
                        const struct pp_study_options *options, bool by_clock)
{
    struct json_object *simulation = json_object_new_object();
    if (!pp_json_add(object, "simulation", simulation))
        return false;
    pp_json_on_one_line(simulation);
    bool good = pp_json_add(simulation, "seed", json_object_new_uint64(options->seed));
    if (good && options->error > 0.0)
        good = pp_json_number(simulation, "error", 100.0 * options->error);
    if (good && options->samples > 0)
        good =
            pp_json_add(simulation, "samples", json_object_new_int64(options->samples));
    if (good && options->seconds > 0.0)
        good = pp_json_number(simulation, "time", options->seconds);
    if (good && by_clock)
        good = pp_json_text(simulation, "stopped", "time");
    return good;
}

bool pp_json_warnings(struct json_object *object, const struct pp_mistakes *doubts)
{
    if (!doubts || doubts->count == 0)
        return true;
    struct json_object *list = json_object_new_array();
    bool good = pp_json_add(object, "warnings", list);
    for (int i = 0; i < doubts->count && good; i++) {
        struct json_object *warning = json_object_new_object();
        const struct pp_input_mistake *doubt = &doubts->list[i];
        good = warning
               && (doubt->line > 0
                       ? pp_json_add(warning, "line", json_object_new_int(doubt->line))
                       : json_object_object_add(warning, "line", NULL) == 0)
               && pp_json_text(warning, "text", doubt->text);
        good = pp_json_append(list, pp_json_whole(warning, good));
    }
    return good;
}

/* Returns an array of the rooms' objects, or the object of the only room. NULL: out of
 * memory. */
static struct json_object *gather_room_objects(pp_json_room *room, const void *all,
                                               int count, bool several)
{
    if (!several)
        return room(all, 0);
    struct json_object *list = json_object_new_array();
    bool good = list != NULL;
    for (int i = 0; i < count && good; i++)
        good = pp_json_append(list, room(all, i));
    return pp_json_whole(list, good);
}

enum pp_status pp_json_print(FILE *out, struct json_object *object,
                             struct pp_error *err)
{
    const char *text = object ? json_object_to_json_string_ext(
                           object, PP_JSON_STYLE | JSON_C_TO_STRING_PRETTY)
                              : NULL;
    if (text)
        fprintf(out, "%s\n", text);
    json_object_put(object);
    return text ? PP_OK : pp_fail_memory(err);
}

enum pp_status pp_json_print_rooms(FILE *out, pp_json_room *room, const void *all,
                                   int count, bool several, struct pp_error *err)
{
    return pp_json_print(out, gather_room_objects(room, all, count, several), err);
}
