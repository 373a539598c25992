#include "cli/print_size.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

#include "cli/json.h"
#include "cli/print.h"
#include "cli/utf8.h"

enum { LABEL = 15, TEXT_BYTES = 640 };

static const double same_m = 1e-9;

/* ---- Words ---- */

static void append(char text[TEXT_BYTES], const char *format, ...)
    __attribute__((format(printf, 2, 3)));
static void append(char text[TEXT_BYTES], const char *format, ...)
{
    size_t length = strlen(text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text + length, TEXT_BYTES - length, format, arguments);
    va_end(arguments);
}

/* "2.00 %", with as many digits as a small one needs. */
static void append_per_cent(char text[TEXT_BYTES], double share)
{
    double value = 100.0 * share;
    append(text, "%.*f %%", value < 0.0995 ? 4 : value < 0.995 ? 3 : 2, value);
}

static void put_fact(const char *label, const char *text, int width, FILE *out)
{
    fprintf(out, "  %-*s", LABEL, label);
    pp_print_wrapped(text, LABEL + 2, LABEL + 2, width, out);
}

/* Did the sizing change opening `index`, or add it? */
static bool is_changed(const struct pp_size_result *result, int index)
{
    const struct pp_room *before = result->room->room;
    if (index >= pp_room_opening_count(before))
        return true;
    struct pp_room_opening a = pp_room_opening_at(before, index);
    struct pp_room_opening b = pp_room_opening_at(result->answer.room, index);
    return a.kind != PP_OPENING
           && (a.place.left_m != b.place.left_m || a.place.width_m != b.place.width_m
               || a.place.sill_m != b.place.sill_m
               || a.place.height_m != b.place.height_m);
}

/* The length that a change is about. */
static double length_of(struct pp_place place, enum pp_size_change change)
{
    switch (change) {
    case PP_CHANGE_HEIGHT:
        return place.height_m;
    case PP_CHANGE_HEAD:
        return place.sill_m + place.height_m;
    case PP_CHANGE_SILL:
        return place.sill_m;
    case PP_CHANGE_WIDTH:
    case PP_CHANGE_NUMBER:
        break;
    }
    return place.width_m;
}

/* "a width of 1.238 m instead of 2.6 m", "widths 0.61 times as large", "3 windows
 * instead of 2". */
static void append_size(char text[TEXT_BYTES], const struct pp_size_result *result,
                        enum pp_size_change change)
{
    static const char *const phrases[] = {"a width of %.10g m", "a height of %.10g m",
                                          "a head at %.10g m", "a sill at %.10g m"};
    const struct pp_room *before = result->room->room, *after = result->answer.room;
    int was = pp_room_opening_count(before), is = pp_room_opening_count(after);
    if (change == PP_CHANGE_NUMBER) {
        int windows = 0;
        for (int i = 0; i < was; i++)
            windows += pp_room_opening_at(before, i).kind == PP_WINDOW;
        append(text, "%d window%s instead of %d in the room", windows + is - was,
               windows + is - was == 1 ? "" : "s", windows);
        return;
    }
    int changed = 0;
    bool alike = true, from_alike = true;
    double length = NAN, from = NAN, factor = NAN;
    for (int i = 0; i < was; i++) {
        if (!is_changed(result, i))
            continue;
        double a = length_of(pp_room_opening_at(before, i).place, change);
        double b = length_of(pp_room_opening_at(after, i).place, change);
        alike = alike && (changed == 0 || fabs(b - length) <= same_m);
        from_alike = from_alike && (changed == 0 || fabs(a - from) <= same_m);
        if (changed++ == 0) {
            length = b;
            from = a;
            factor = b / a;
        }
    }
    if (changed == 0)
        append(text, "the room as it is");
    else if (alike) {
        append(text, phrases[change], length);
        if (from_alike)
            append(text, " instead of %.10g m", from);
    } else {
        append(text, "sizes as below (the first %.3g times the present one)", factor);
    }
}

/* The last line of the answer: what was found, or why nothing. */
static void append_answer(char text[TEXT_BYTES], const struct pp_size_result *result,
                          enum pp_size_change change)
{
    static const char *const ends[] = {"widest", "highest", "highest", "lowest",
                                       "most"};
    const struct pp_size_answer *answer = &result->answer;
    switch (answer->verdict) {
    case PP_SIZE_REACHED:
        append_size(text, result, change);
        append(text, " gives ");
        append_per_cent(text, answer->reading.value);
        break;
    case PP_SIZE_SMALLEST_EXCEEDS:
        append(text, "the target is exceeded without it: even ");
        append_size(text, result, change);
        append(text, " leaves ");
        append_per_cent(text, answer->reading.value);
        break;
    case PP_SIZE_OUT_OF_REACH:
        if (answer->reading.value <= answer->now.value * (1.0 + 1e-4)) {
            append(text, "out of reach: this change does not help");
            break;
        }
        append(text, "out of reach: ");
        if (answer->is_largest)
            append(text, "even the %s that there is space for, ", ends[change]);
        else
            append(text, "the best, ");
        append_size(text, result, change);
        append(text, ", gives only ");
        append_per_cent(text, answer->reading.value);
        break;
    case PP_SIZE_NO_VALUE:
        append(text, "none: %s", result->why);
        break;
    }
}

/* The element of an opening as the room file would have it. */
static void append_element(char text[TEXT_BYTES], const struct pp_room_opening *opening)
{
    struct pp_place p = opening->place;
    if (opening->kind == PP_WINDOW)
        append(text,
               "<window wall=\"%s\" left=\"%.10g\" sill=\"%.10g\" width=\"%.10g\" "
               "height=\"%.10g\"/>",
               opening->wall, p.left_m, p.sill_m, p.width_m, p.height_m);
    else
        append(text,
               "<rooflight x=\"%.10g\" y=\"%.10g\" width=\"%.10g\" depth=\"%.10g\"/>",
               p.left_m, p.sill_m, p.width_m, p.height_m);
}

/* ---- Text ---- */

static void print_elements(const struct pp_size_result *result, FILE *out)
{
    const struct pp_room *room = result->answer.room;
    for (int i = 0; i < pp_room_opening_count(room); i++) {
        if (!is_changed(result, i))
            continue;
        char text[TEXT_BYTES] = "";
        struct pp_room_opening opening = pp_room_opening_at(room, i);
        append_element(text, &opening);
        fputs("    ", out);
        pp_utf8_put(out, text);
        fputc('\n', out);
    }
}

static void print_room(const struct pp_size_result *result,
                       const struct pp_size_options *options, int width, bool utf8,
                       FILE *out)
{
    const struct pp_size_answer *answer = &result->answer;
    char text[TEXT_BYTES] = "";
    append_per_cent(text, options->target);
    int points = options->room.points.count;
    append(text, " %s, by %s",
           points == 0   ? "on average over the working plane"
           : points == 1 ? "at the point"
                         : "at the lowest of the points",
           options->by);
    put_fact("wanted", text, width, out);
    if (isfinite(answer->now.value)) {
        text[0] = '\0';
        append_per_cent(text, answer->now.value);
        put_fact("as it is", text, width, out);
    }
    text[0] = '\0';
    append_answer(text, result, options->change);
    put_fact(pp_size_change_words[options->change], text, width, out);
    if (isfinite(result->traced.value)) {
        text[0] = '\0';
        append_per_cent(text, result->traced.value);
        append(text, " %s %.2g", utf8 ? "\302\261" : "+-",
               100.0 * result->traced.std_error);
        put_fact("traced", text, width, out);
    }
    if (answer->room && answer->verdict == PP_SIZE_REACHED) {
        fputc('\n', out);
        print_elements(result, out);
    }
}

void pp_print_size(const struct pp_size_results *results, int width, bool utf8,
                   FILE *out)
{
    for (int i = 0; i < results->count; i++) {
        const struct pp_size_result *result = &results->list[i];
        if (i > 0)
            fputc('\n', out);
        pp_print_title(result->room->world, result->room->file, out);
        fputc('\n', out);
        print_room(result, results->options, width, utf8, out);
    }
}

/* ---- JSON ---- */

static bool add_reading(struct json_object *object, const char *key,
                        const struct pp_reading *reading)
{
    struct json_object *entry = json_object_new_object();
    if (!pp_json_add(object, key, entry))
        return false;
    pp_json_on_one_line(entry);
    bool good = pp_json_number(entry, "value", 100.0 * reading->value);
    if (good && isfinite(reading->std_error))
        good = pp_json_number(entry, "se", 100.0 * reading->std_error);
    return good;
}

static bool add_opening(struct json_object *list, const struct pp_room_opening *opening)
{
    struct json_object *object = json_object_new_object();
    if (!object || json_object_array_add(list, object) != 0) {
        json_object_put(object);
        return false;
    }
    pp_json_on_one_line(object);
    bool window = opening->kind == PP_WINDOW;
    struct pp_place p = opening->place;
    return pp_json_add(object, "line", json_object_new_int(opening->line))
           && (!window || pp_json_text(object, "wall", opening->wall))
           && pp_json_number(object, window ? "left" : "x", p.left_m)
           && pp_json_number(object, window ? "sill" : "y", p.sill_m)
           && pp_json_number(object, "width", p.width_m)
           && pp_json_number(object, window ? "height" : "depth", p.height_m);
}

static bool add_answer(struct json_object *object, const struct pp_size_result *result)
{
    const struct pp_size_answer *answer = &result->answer;
    struct json_object *windows = json_object_new_array();
    if (!pp_json_add(object, "windows", windows))
        return false;
    for (int i = 0; i < pp_room_opening_count(answer->room); i++) {
        struct pp_room_opening opening = pp_room_opening_at(answer->room, i);
        if (is_changed(result, i) && !add_opening(windows, &opening))
            return false;
    }
    return true;
}

static struct json_object *room(const struct pp_size_results *results,
                                const struct pp_size_result *result)
{
    const struct pp_size_options *options = results->options;
    const struct pp_size_answer *answer = &result->answer;
    char text[TEXT_BYTES] = "";
    append_answer(text, result, options->change);
    bool reached = answer->verdict == PP_SIZE_REACHED;
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_text(object, "format", "pepperpot-size-1");
    if (good && results->more_than_one_file)
        good = pp_json_text(object, "file", result->room->file);
    good = good && pp_json_text(object, "room", result->room->world->name)
           && pp_json_number(object, "target", 100.0 * options->target)
           && pp_json_text(object, "of",
                           options->room.points.count > 0 ? "points" : "average")
           && pp_json_text(object, "method", options->by)
           && pp_json_text(object, "change", pp_size_change_words[options->change])
           && pp_json_add(object, "reached", json_object_new_boolean(reached))
           && pp_json_text(object, reached ? "answer" : "why", text)
           && add_reading(object, "now", &answer->now)
           && add_reading(object, "sized", &answer->reading);
    if (good && isfinite(result->traced.value))
        good = add_reading(object, "traced", &result->traced);
    if (good && answer->room)
        good = add_answer(object, result);
    if (good)
        return object;
    json_object_put(object);
    return NULL;
}

enum pp_status pp_print_size_json(const struct pp_size_results *results, FILE *out,
                                  struct pp_error *err)
{
    struct json_object *whole = results->several ? json_object_new_array() : NULL;
    for (int i = 0; i < results->count; i++) {
        struct json_object *one = room(results, &results->list[i]);
        if (!results->several) {
            whole = one;
        } else if (!one || !whole || json_object_array_add(whole, one) != 0) {
            json_object_put(one);
            json_object_put(whole);
            whole = NULL;
            break;
        }
    }
    const char *text = whole ? json_object_to_json_string_ext(
                           whole, PP_JSON_STYLE | JSON_C_TO_STRING_PRETTY)
                             : NULL;
    if (text)
        fprintf(out, "%s\n", text);
    json_object_put(whole);
    return text ? PP_OK : pp_fail_memory(err);
}
