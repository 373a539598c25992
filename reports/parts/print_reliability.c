/* print_reliability.c - prints sentences on reliability as notes, and their data as
 * JSON. */
#include "reports/parts/print_reliability.h"

#include "reports/parts/json.h"
#include "reports/parts/print.h"

enum { SENTENCE = 640 };

static void put_note(const char *text, int width, FILE *out)
{
    if (!text[0])
        return;
    fputs("  - ", out);
    pp_print_wrapped(text, 4, 4, width, out);
}

void pp_print_reliability(const struct pp_reliability *reliability, int width,
                          FILE *out)
{
    char text[SENTENCE];
    pp_reliability_sentence(reliability, text, sizeof text);
    if (text[0] || reliability->grounds[0])
        fputc('\n', out);
    put_note(reliability->grounds, width, out);
    put_note(text, width, out);
}

static bool add_kinds(struct json_object *object,
                      const struct pp_reliability *reliability)
{
    struct json_object *list = json_object_new_array();
    bool good = pp_json_add(object, "kinds", list);
    for (int kind = 0; kind < PP_RELIABILITY_KINDS && good; kind++) {
        if (!reliability->is[kind])
            continue;
        const struct pp_reliability_band *band = pp_reliability_band(kind);
        struct json_object *one = json_object_new_object();
        good = pp_json_append(list, one)
               && pp_json_text(one, "kind", pp_reliability_names[kind])
               && pp_json_number(one, "measure", reliability->share[kind])
               && pp_json_text(one, "of", band->of)
               && pp_json_number(one, "low", band->low)
               && pp_json_number(one, "high", band->high);
    }
    return good;
}

bool pp_print_reliability_json(struct json_object *object,
                               const struct pp_reliability *reliability)
{
    char text[SENTENCE];
    struct json_object *entry = json_object_new_object();
    pp_reliability_sentence(reliability, text, sizeof text);
    bool good =
        pp_json_add(object, "reliability", entry)
        && pp_json_add(entry, "relied_on", json_object_new_boolean(!reliability->any));
    if (good && reliability->any)
        good = pp_json_text(entry, "why", text) && add_kinds(entry, reliability);
    if (good && reliability->grounds[0])
        good = pp_json_text(entry, "grounds", reliability->grounds);
    return good;
}
