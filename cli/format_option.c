/* format_option.c - parses the value of --format: text, json or csv. */
#include "cli/format_option.h"

#include <string.h>

static const char *const names[] = {
    [PP_FORMAT_TEXT] = "text", [PP_FORMAT_JSON] = "json", [PP_FORMAT_CSV] = "csv"};

static enum pp_status read_of(int count, const char *expected, const char *text,
                              void *place, struct pp_error *err)
{
    for (int i = 0; i < count; i++)
        if (strcmp(text, names[i]) == 0) {
            *(enum pp_format *)place = (enum pp_format)i;
            return PP_OK;
        }
    return pp_fail(err, PP_BAD_INPUT, "%s", expected);
}

static enum pp_status read_any(const char *text, void *place, struct pp_error *err)
{
    return read_of(3, "text, json or csv", text, place, err);
}

static enum pp_status read_text_or_json(const char *text, void *place,
                                        struct pp_error *err)
{
    return read_of(2, "text or json", text, place, err);
}

const struct pp_option pp_format_option[] = {
    {"format", 'f', "FORMAT", "text (default), json or csv.", read_any, 0},
    {0},
};

const struct pp_option pp_text_or_json_option[] = {
    {"format", 'f', "FORMAT", "text (default) or json.", read_text_or_json, 0},
    {0},
};
