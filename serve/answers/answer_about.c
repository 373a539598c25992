/* answer_about.c - see answer_about.h. */
#include "serve/answers/answer_about.h"

#include <stdlib.h>
#include <string.h>

static struct json_object *names_in(enum pp_list list)
{
    struct json_object *names = json_object_new_array();
    const char *name;
    for (int i = 0; names && (name = pp_list_name(list, i)); i++) {
        struct json_object *item = json_object_new_object();
        json_object_object_add(item, "name", json_object_new_string(name));
        json_object_object_add(item, "summary",
                               json_object_new_string(pp_list_summary(list, i)));
        json_object_array_add(names, item);
    }
    return names;
}

bool pp_answer_about(struct pp_task *task)
{
    const struct pp_serve_options *options = task->server->options;
    struct json_object *about = json_object_new_object();
    json_object_object_add(about, "version", json_object_new_string(pp_version_text()));
    json_object_object_add(about, "methods", names_in(PP_LIST_METHODS));
    json_object_object_add(about, "charts", names_in(PP_LIST_CHARTS));
    json_object_object_add(about, "criteria", names_in(PP_LIST_CRITERIA));
    json_object_object_add(about, "jobs",
                           json_object_new_boolean(options->jobs != NULL));
    json_object_object_add(about, "room",
                           json_object_new_boolean(options->room != NULL));
    pp_task_answer_json(task, MHD_HTTP_OK, about);
    return true;
}

bool pp_answer_about_room(struct pp_task *task)
{
    const struct pp_serve_options *options = task->server->options;
    struct json_object *answer = json_object_new_object();
    if (!options->room) {
        json_object_put(answer);
        pp_task_fail(task, MHD_HTTP_NOT_FOUND, "the server was started without a room");
        return true;
    }
    json_object_object_add(
        answer, "room",
        json_object_new_string_len(options->room, (int)options->room_length));
    pp_task_answer_json(task, MHD_HTTP_OK, answer);
    return true;
}
