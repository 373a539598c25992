/* size_report.c - prints sized windows as text and as JSON, "pepperpot-size-1". */
#include "reports/size_report.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "reports/parts/json.h"
#include "reports/parts/json_room.h"
#include "reports/parts/print.h"
#include "reports/parts/print_band.h"
#include "reports/parts/print_reliability.h"
#include "reports/parts/format.h"
#include "model/base/text.h"

enum { LABEL = 15, TEXT_BYTES = 640 };

static const double same_m = 1e-9;

/* Appends a fraction in per cent, "2.00 %", with more decimals for small values. */
static void append_per_cent(char text[TEXT_BYTES], double share)
{
    double value = 100.0 * share;
    pp_text_append(text, TEXT_BYTES, "%.*f %%",
                   value < 0.0995  ? 4
                   : value < 0.995 ? 3
                                   : 2,
                   value);
}

/* Appends a reading, with its standard error if known. */
static void append_reading(char text[TEXT_BYTES], const struct pp_reading *reading,
                           bool utf8)
{
    append_per_cent(text, reading->value);
    if (isfinite(reading->std_error))
        pp_text_append(text, TEXT_BYTES, " %s %.2g", utf8 ? "\302\261" : "+-",
                       100.0 * reading->std_error);
}

static void print_size_fact(const char *label, const char *text, int width, FILE *out)
{
    fprintf(out, "  %-*s", LABEL, label);
    pp_print_wrapped(text, LABEL + 2, LABEL + 2, width, out);
}

double pp_size_report_length(struct pp_opening_place place, enum pp_size_change change)
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

/* Appends the new size: "a width of 1.238 m instead of 2.6 m", "a width of 1.2 m
 * (window, the others as below)" or "3 windows instead of 2". */
static void append_size(char text[TEXT_BYTES], const struct pp_size_room_result *result,
                        enum pp_size_change change)
{
    static const char *const phrases[] = {"a width of %.10g m", "a height of %.10g m",
                                          "a head at %.10g m", "a sill at %.10g m"};
    const struct pp_room *before = result->room->room;
    if (change == PP_CHANGE_NUMBER) {
        int was = pp_room_opening_count(before);
        int more = pp_room_opening_count(result->answer.room) - was, windows = 0;
        for (int i = 0; i < was; i++)
            windows += pp_room_opening_at(before, i).kind == PP_WINDOW;
        if (more == 0)
            pp_text_append(text, TEXT_BYTES, "the present number, %d,", windows);
        else
            pp_text_append(text, TEXT_BYTES, "%d window%s instead of %d",
                           windows + more, windows + more == 1 ? "" : "s", windows);
        return;
    }
    if (result->edit_count == 0) {
        pp_text_append(text, TEXT_BYTES, "the room as it is");
        return;
    }
    bool alike = true, were_alike = true;
    double first = NAN, first_was = NAN;
    for (int i = 0; i < result->edit_count; i++) {
        const struct pp_text_edit *edit = &result->edits[i];
        double is = pp_size_report_length(edit->place, change);
        double was = pp_size_report_length(
            pp_room_opening_at(before, edit->opening).place, change);
        first = i == 0 ? is : first;
        first_was = i == 0 ? was : first_was;
        alike = alike && fabs(is - first) <= same_m;
        were_alike = were_alike && fabs(was - first_was) <= same_m;
    }
    pp_text_append(text, TEXT_BYTES, phrases[change], first);
    if (alike && were_alike)
        pp_text_append(text, TEXT_BYTES, " instead of %.10g m", first_was);
    else if (!alike)
        pp_text_append(
            text, TEXT_BYTES, " (%s, the others %s)",
            pp_world_label(result->room->world,
                           pp_room_opening_at(before, result->edits[0].opening).line),
            result->answer.verdict == PP_SIZE_REACHED ? "as below" : "likewise");
}

/* True if append_size describes several windows. */
static bool is_plural(const struct pp_size_room_result *result,
                      enum pp_size_change change)
{
    const struct pp_room *before = result->room->room, *after = result->answer.room;
    int windows = 0, was = pp_room_opening_count(before);
    for (int i = 0; i < was; i++)
        windows += pp_room_opening_at(before, i).kind == PP_WINDOW;
    int more = pp_room_opening_count(after) - was;
    return change == PP_CHANGE_NUMBER && more != 0 && windows + more != 1;
}

/* Appends the last part of the answer: the result, or the reason why there is none. */
static void append_answer(char text[TEXT_BYTES],
                          const struct pp_size_room_result *result,
                          enum pp_size_change change, bool utf8)
{
    static const char *const ends[] = {"widest", "highest", "highest", "lowest",
                                       "most"};
    const struct pp_size_answer *answer = &result->answer;
    switch (answer->verdict) {
    case PP_SIZE_REACHED:
        append_size(text, result, change);
        pp_text_append(text, TEXT_BYTES,
                       is_plural(result, change) ? " give " : " gives ");
        append_reading(text, &answer->reading, utf8);
        break;
    case PP_SIZE_SMALLEST_EXCEEDS:
        pp_text_append(text, TEXT_BYTES,
                       "the target is exceeded even by the smallest size: ");
        append_size(text, result, change);
        pp_text_append(text, TEXT_BYTES, " gives ");
        append_reading(text, &answer->reading, utf8);
        break;
    case PP_SIZE_OUT_OF_REACH:
        if (result->holds && result->edit_count == 0 && answer->is_largest) {
            pp_text_append(text, TEXT_BYTES,
                           "out of reach: there is no space for more");
            break;
        }
        if (result->holds
            && answer->reading.value <= answer->now.value * (1.0 + 1e-4)) {
            pp_text_append(text, TEXT_BYTES, "out of reach: this change has no effect");
            break;
        }
        pp_text_append(text, TEXT_BYTES, "out of reach: ");
        if (answer->is_largest)
            pp_text_append(text, TEXT_BYTES, "even the %s that fits, ", ends[change]);
        else
            pp_text_append(text, TEXT_BYTES, "the best, ");
        append_size(text, result, change);
        pp_text_append(text, TEXT_BYTES,
                       is_plural(result, change) ? ", give only " : ", gives only ");
        append_reading(text, result->holds ? &answer->reading : &result->traced, utf8);
        if (!result->holds)
            pp_text_append(text, TEXT_BYTES, " by simulation");
        break;
    case PP_SIZE_NO_VALUE:
        pp_text_append(text, TEXT_BYTES, "none: %s", result->why);
        break;
    }
}

/* Makes the text of an opening's element as in the room file. The caller frees
 * *element. */
static enum pp_status element_of(char **element,
                                 const struct pp_size_room_result *result,
                                 struct pp_text_edit edit, struct pp_error *err)
{
    edit.opening += result->file_opening;
    return pp_room_text_element(element, result->file_text, result->file_length, &edit,
                                err);
}

/* ---- text ---- */

/* Prints an element with the line breaks of the file. Lines after the first are
 * indented further. */
static void put_element(const char *element, FILE *out)
{
    for (bool more = true; more;) {
        int length = (int)strcspn(element, "\n");
        char line[1024];
        snprintf(line, sizeof line, "%.*s", length, element);
        line[strcspn(line, "\r")] = '\0';
        fputs("    ", out);
        pp_format_utf8_put(out, line);
        fputc('\n', out);
        more = element[length] != '\0';
        element += length + more;
        if (more && *element) {
            element += strspn(element, " \t");
            fputs("        ", out);
        }
    }
}

static enum pp_status print_elements(const struct pp_size_room_result *result,
                                     FILE *out, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < result->edit_count && status == PP_OK; i++) {
        const struct pp_text_edit *edit = &result->edits[i];
        int line = pp_room_opening_at(result->room->room, edit->opening).line;
        const char *label = pp_world_label(result->room->world, line);
        if (edit->kind == PP_TEXT_REMOVE) {
            fprintf(out, "    %s, line %d: removed\n", label, line);
            continue;
        }
        char *element;
        status = element_of(&element, result, *edit, err);
        if (status != PP_OK)
            return status;
        fprintf(out, "    %s%s, line %d:\n", edit->kind == PP_TEXT_ADD ? "after " : "",
                label, line);
        put_element(element, out);
        free(element);
    }
    return status;
}

static void append_wanted(char text[TEXT_BYTES],
                          const struct pp_size_room_result *result,
                          const struct pp_size_request *request)
{
    static const char *const of_what[] = {[PP_GIVES_DIRECT] = "direct component ",
                                          [PP_GIVES_INTERNAL] =
                                              "internally reflected component ",
                                          [PP_GIVES_WHOLE] = ""};
    if (request->criterion) {
        pp_text_append(text, TEXT_BYTES,
                       "all requirements of %s: 100 %% of the requirement that is "
                       "hardest to reach%s",
                       request->criterion, request->traced ? ", simulated" : "");
        return;
    }
    append_per_cent(text, request->target);
    int points = request->study->points.count;
    pp_text_append(text, TEXT_BYTES, " %s%s, by %s",
                   of_what[pp_size_room_gives(result->method)],
                   points == 0   ? "on average over the working plane"
                   : points == 1 ? "at the point"
                                 : "at the point with the lowest value",
                   result->method);
}

static enum pp_status print_sized_room(const struct pp_size_room_result *result,
                                       const struct pp_size_request *request, int width,
                                       bool utf8, FILE *out, struct pp_error *err)
{
    const struct pp_size_answer *answer = &result->answer;
    char text[TEXT_BYTES] = "";
    append_wanted(text, result, request);
    print_size_fact("target", text, width, out);
    if (isfinite(answer->now.value)) {
        text[0] = '\0';
        append_reading(text, &answer->now, utf8);
        print_size_fact("as it is", text, width, out);
    }
    text[0] = '\0';
    append_answer(text, result, request->change, utf8);
    print_size_fact(pp_size_room_change_words[request->change], text, width, out);
    if (pp_band_is_known(result->band)) {
        char band[48];
        pp_print_band(band, sizeof band, result->band);
        snprintf(text, sizeof text,
                 "%s %%: the true value was in this range in 95 of 100 similar "
                 "simulated rooms (the atlas)",
                 band);
        print_size_fact("band", text, width, out);
    }
    if (isfinite(result->traced.value)) {
        text[0] = '\0';
        append_reading(text, &result->traced, utf8);
        if (!result->holds && answer->verdict == PP_SIZE_OUT_OF_REACH)
            pp_text_append(text, TEXT_BYTES, ", compared with %s with ",
                           result->method ? result->method : "the hand figure");
        if (!result->holds && answer->verdict == PP_SIZE_OUT_OF_REACH)
            append_reading(text, &answer->reading, utf8);
        else if (!result->holds)
            pp_text_append(text, TEXT_BYTES,
                           ", below the target: do not use this size; add --by traced "
                           "to find one by simulation");
        print_size_fact("simulated", text, width, out);
    }
    if (!request->traced && !request->criterion)
        pp_print_reliability(&result->reliability, width, out);
    if (answer->verdict != PP_SIZE_REACHED || result->edit_count == 0)
        return PP_OK;
    fputc('\n', out);
    return print_elements(result, out, err);
}

enum pp_status pp_size_report(const struct pp_size_results *results, int width,
                              bool utf8, FILE *out, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < results->count && status == PP_OK; i++) {
        const struct pp_size_room_result *result = &results->list[i];
        if (i > 0)
            fputc('\n', out);
        pp_print_title(result->room->world, result->room->file, out);
        fputc('\n', out);
        status = print_sized_room(result, results->request, width, utf8, out, err);
    }
    return status;
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

static bool add_edit(struct json_object *list, const struct pp_size_room_result *result,
                     const struct pp_text_edit *edit)
{
    static const char *const words[] = {"changed", "added", "removed"};
    struct json_object *object = json_object_new_object();
    if (!pp_json_append(list, object))
        return false;
    pp_json_on_one_line(object);
    struct pp_room_opening opening =
        pp_room_opening_at(result->room->room, edit->opening);
    bool window = opening.kind == PP_WINDOW;
    struct pp_opening_place p = edit->place;
    bool good =
        pp_json_add(object, "line", json_object_new_int(opening.line))
        && pp_json_room_add_opening_names(object, result->room->world, opening.line)
        && pp_json_text(object, "is", words[edit->kind])
        && (!window || pp_json_text(object, "wall", opening.wall));
    if (!good || edit->kind == PP_TEXT_REMOVE)
        return good;
    char *element;
    if (element_of(&element, result, *edit, NULL) != PP_OK)
        return false;
    good = pp_json_number(object, window ? "left" : "x", p.left_m)
           && pp_json_number(object, window ? "sill" : "y", p.sill_m)
           && pp_json_number(object, "width", p.width_m)
           && pp_json_number(object, window ? "height" : "depth", p.height_m)
           && pp_json_text(object, "element", element);
    free(element);
    return good;
}

static bool add_answer(struct json_object *object,
                       const struct pp_size_room_result *result)
{
    struct json_object *windows = json_object_new_array();
    if (!pp_json_add(object, "windows", windows))
        return false;
    for (int i = 0; i < result->edit_count; i++)
        if (!add_edit(windows, result, &result->edits[i]))
            return false;
    return true;
}

static struct json_object *room(const void *all, int index)
{
    const struct pp_size_results *results = all;
    const struct pp_size_room_result *result = &results->list[index];
    const struct pp_size_request *request = results->request;
    const struct pp_size_answer *answer = &result->answer;
    char text[TEXT_BYTES] = "";
    append_answer(text, result, request->change, true);
    bool reached = answer->verdict == PP_SIZE_REACHED;
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_text(object, "format", "pepperpot-size-1");
    if (good && results->more_than_one_file)
        good = pp_json_text(object, "file", result->room->file);
    good = good && pp_json_text(object, "room", result->room->world->name)
           && pp_json_warnings(object, result->room->doubts)
           && pp_json_number(object, "target", 100.0 * request->target)
           && pp_json_text(object, "of",
                           request->criterion                 ? "criterion"
                           : request->study->points.count > 0 ? "points"
                                                              : "average")
           && (!request->criterion
               || pp_json_text(object, "criterion", request->criterion))
           && pp_json_text(object, "method", result->method)
           && pp_json_text(object, "change", pp_size_room_change_words[request->change])
           && pp_json_add(object, "reached", json_object_new_boolean(reached))
           && pp_json_text(object, reached ? "answer" : "why", text)
           && add_reading(object, "now", &answer->now)
           && add_reading(object, "sized", &answer->reading)
           && pp_print_band_json(object, result->band);
    if (good && isfinite(result->traced.value))
        good = add_reading(object, "traced", &result->traced)
               && pp_json_add(object, "holds", json_object_new_boolean(result->holds));
    if (good && !request->traced && !request->criterion)
        good = pp_print_reliability_json(object, &result->reliability);
    if (good && answer->room)
        good = add_answer(object, result);
    return pp_json_whole(object, good);
}

enum pp_status pp_size_report_json(const struct pp_size_results *results, FILE *out,
                                   struct pp_error *err)
{
    return pp_json_print_rooms(out, room, results, results->count, results->several,
                               err);
}
