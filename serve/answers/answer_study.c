/* answer_study.c - see answer_study.h. */
#include "serve/answers/answer_study.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "serve/answers/asked_room.h"

/* ---- df ---- */

static const struct {
    const char *name, *type;
} formats[] = {
    [PP_FORMAT_TEXT] = {"text", "text/plain; charset=utf-8"},
    [PP_FORMAT_JSON] = {"json", "application/json"},
    [PP_FORMAT_CSV] = {"csv", "text/csv; charset=utf-8"},
};

static bool df_format(enum pp_format *format, struct pp_task *task)
{
    struct json_object *name;
    *format = PP_FORMAT_JSON;
    if (!pp_asked_room_option(&name, task, "format", json_type_string))
        return false;
    for (int i = PP_FORMAT_TEXT; name && i <= PP_FORMAT_CSV; i++)
        if (strcmp(json_object_get_string(name), formats[i].name) == 0) {
            *format = (enum pp_format)i;
            return true;
        }
    if (name)
        pp_task_fail(task, MHD_HTTP_BAD_REQUEST, "format: expected json, csv or text");
    return !name;
}

bool pp_answer_study_df(struct pp_task *task)
{
    static const char *const names[] = {"methods", "points",  "sky",    "room",
                                        "explain", "formula", "format", NULL};
    struct pp_asked_room asked = {0};
    struct json_object *methods, *explain, *formula;
    struct pp_error err = {0};
    enum pp_format format;
    if (!pp_asked_room_options(task, names) || !df_format(&format, task)
        || !pp_asked_room_option(&methods, task, "methods", json_type_string)
        || !pp_asked_room_option(&explain, task, "explain", json_type_boolean)
        || !pp_asked_room_option(&formula, task, "formula", json_type_string))
        return true;
    if (pp_asked_room_open(&asked, task)) {
        char *bytes = NULL;
        size_t length;
        enum pp_status status = PP_OK;
        if (formula)
            status =
                pp_study_formula(asked.study, json_object_get_string(formula), &err);
        if (status == PP_OK)
            status = pp_study_methods(asked.study, json_object_get_string(methods),
                                      json_object_get_boolean(explain), &err);
        if (status == PP_OK)
            status = pp_study_report(asked.study, format, &bytes, &length, &err);
        if (status == PP_OK)
            pp_task_answer(task, MHD_HTTP_OK, formats[format].type, bytes, length);
        else
            pp_task_fail_with(task, &err);
    }
    pp_asked_room_clear(&asked);
    return true;
}

/* ---- plan ---- */

/* Answers with { "scene": ..., "plan": ... }, made from two JSON texts. plan NULL: the
 * answer has "plan": null, and "why" gives the reason. */
static void answer_plan(struct pp_task *task, const char *scene, const char *plan,
                        const struct pp_error *err)
{
    char *bytes = NULL;
    size_t length = 0;
    FILE *out = open_memstream(&bytes, &length);
    struct json_object *why = json_object_new_string(err->message);
    if (out) {
        fprintf(out, "{ \"scene\": %s, \"plan\": %s", scene, plan ? plan : "null");
        if (!plan)
            fprintf(out, ", \"why\": %s", json_object_to_json_string(why));
        fputs(" }\n", out);
        if (fclose(out) != 0) {
            free(bytes);
            bytes = NULL;
        }
    }
    json_object_put(why);
    pp_task_answer(task, MHD_HTTP_OK, "application/json", bytes, length);
}

bool pp_answer_study_plan(struct pp_task *task)
{
    static const char *const names[] = {"methods", "tolerance", "average", "points",
                                        "sky",     "room",      NULL};
    struct pp_asked_room asked = {0};
    struct json_object *methods, *average;
    double tolerance;
    if (!pp_asked_room_options(task, names)
        || !pp_asked_room_option(&methods, task, "methods", json_type_string)
        || !pp_asked_room_option(&average, task, "average", json_type_boolean)
        || !pp_asked_room_number(&tolerance, task, "tolerance", 0.01, 0.001, 1.0))
        return true;
    if (pp_asked_room_open(&asked, task)) {
        struct pp_error err = {0};
        char *scene = NULL, *plan = NULL;
        size_t length;
        enum pp_status status = pp_study_scene(asked.study, &scene, &length, &err);
        pp_study_plan_without_average(asked.study,
                                      average && !json_object_get_boolean(average));
        if (status == PP_OK)
            status = pp_study_plan(asked.study, json_object_get_string(methods),
                                   tolerance, &plan, &length, &err);
        if (status == PP_OK || (scene && status == PP_BAD_INPUT))
            answer_plan(task, scene, plan, &err);
        else
            pp_task_fail_with(task, &err);
        pp_free(plan);
        pp_free(scene);
    }
    pp_asked_room_clear(&asked);
    return true;
}

/* ---- check ---- */

/* Answers with the list of errors in the room file. The list is a result here, not an
 * HTTP error, and is empty for a valid file. */
bool pp_answer_study_check(struct pp_task *task)
{
    static const char *const names[] = {NULL};
    struct json_object *room = NULL;
    if (!pp_asked_room_options(task, names))
        return true;
    json_object_object_get_ex(task->body, "room", &room);
    if (!json_object_is_type(room, json_type_string)) {
        pp_task_fail(task, MHD_HTTP_BAD_REQUEST, "expected { \"room\": TEXT }");
        return true;
    }
    struct pp_asked_room asked = {.text = json_object_get_string(room),
                                  .length = (size_t)json_object_get_string_len(room),
                                  .mistakes = pp_mistakes_create("room")};
    struct pp_error err = {0};
    struct json_object *rooms = json_object_new_array(),
                       *object = json_object_new_object();
    enum pp_status status = asked.mistakes
                                ? pp_building_parse(&asked.building, asked.text,
                                                    asked.length, asked.mistakes, &err)
                                : PP_SYSTEM;
    for (int i = 0; status == PP_OK && i < pp_building_room_count(asked.building);
         i++) {
        status = pp_study_create(&asked.study, asked.building, i, NULL, asked.mistakes,
                                 &err);
        const char *name = status == PP_OK ? pp_study_name(asked.study) : NULL;
        json_object_array_add(rooms, name ? json_object_new_string(name) : NULL);
        pp_study_destroy(asked.study);
        asked.study = NULL;
        if (status == PP_BAD_INPUT)
            status = PP_OK; /* the errors are in the list; other rooms may have further
                             * errors */
    }
    if (status == PP_SYSTEM || !rooms || !object) {
        json_object_put(rooms);
        json_object_put(object);
        pp_task_fail(task, MHD_HTTP_INTERNAL_SERVER_ERROR, "%s",
                     err.message[0] ? err.message : "out of memory");
    } else {
        json_object_object_add(object, "rooms", rooms);
        json_object_object_add(object, "mistakes", pp_asked_room_mistakes(&asked));
        if (status == PP_BAD_INPUT && pp_mistakes_count(asked.mistakes) == 0)
            json_object_object_add(object, "error",
                                   json_object_new_string(err.message));
        pp_task_answer_json(task, MHD_HTTP_OK, object);
    }
    pp_asked_room_clear(&asked);
    return true;
}
