#include "cli/json.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/utf8.h"

bool pp_json_add(struct json_object *object, const char *key, struct json_object *value)
{
    if (value && json_object_object_add(object, key, value) == 0)
        return true;
    json_object_put(value);
    return false;
}

bool pp_json_number(struct json_object *object, const char *key, double number)
{
    char digits[40];
    if (!isfinite(number))
        return json_object_object_add(object, key, NULL) == 0;
    snprintf(digits, sizeof digits, "%.10g", number + 0.0);
    return pp_json_add(object, key, json_object_new_double_s(number, digits));
}

bool pp_json_text(struct json_object *object, const char *key, const char *text)
{
    if (!text)
        return json_object_object_add(object, key, NULL) == 0;
    char *repaired = pp_utf8_repair(text);
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
