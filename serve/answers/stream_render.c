/* stream_render.c - see stream_render.h.
 *
 * Each pass runs pepperpot render. The first pass has 1/8 of the size and 1 path per
 * pixel, the second 1/2 of the size and 4 paths. Two passes at full size have 4 and 16
 * paths per pixel. Each event "picture" contains a PNG in base64.
 */
#include "serve/answers/stream_render.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "serve/answers/asked_room.h"
#include "serve/answers/base64.h"
#include "serve/work/program_words.h"

static const struct {
    int divisor, samples;
} passes[] = {{8, 1}, {2, 4}, {1, 4}, {1, 16}};
enum { PASSES = sizeof passes / sizeof *passes, SIDE_MOST = 1024, SIDE_LEAST = 32 };

struct render {
    int pass, width, height;
};

/* Reads the option "size" ("640x480"; default if missing), within limits. Removes size,
 * samples and format from the options. If the size is invalid, returns false and sets
 * the error answer. */
static bool take_size(struct render *render, struct pp_task *task)
{
    struct json_object *size, *options = NULL;
    render->width = 640;
    render->height = 480;
    if (!pp_asked_room_option(&size, task, "size", json_type_string))
        return false;
    if (size
        && (sscanf(json_object_get_string(size), "%4dx%4d", &render->width,
                   &render->height)
                != 2
            || render->width < SIDE_LEAST || render->height < SIDE_LEAST
            || render->width > SIDE_MOST || render->height > SIDE_MOST)) {
        pp_task_fail(task, MHD_HTTP_BAD_REQUEST,
                     "size: expected \"640x480\", of %d to %d pixels", SIDE_LEAST,
                     SIDE_MOST);
        return false;
    }
    if (json_object_object_get_ex(task->body, "options", &options)) {
        json_object_object_del(options, "size");
        json_object_object_del(options, "samples");
        json_object_object_del(options, "format");
    }
    return true;
}

static bool begin_render(struct pp_task *task)
{
    struct render *render = calloc(1, sizeof *render);
    task->state = render;
    task->free_state = free;
    if (!render || !take_size(render, task))
        return false;
    return pp_asked_room_check(task);
}

static void send_picture(struct pp_task *task, const struct pp_child_result *result,
                         int pass, const char *size)
{
    char *letters = pp_base64_of(result->output, result->length);
    struct json_object *event = json_object_new_object();
    if (letters && event) {
        json_object_object_add(event, "pass", json_object_new_int(pass + 1));
        json_object_object_add(event, "passes", json_object_new_int(PASSES));
        json_object_object_add(event, "size", json_object_new_string(size));
        json_object_object_add(event, "samples",
                               json_object_new_int(passes[pass].samples));
        json_object_object_add(event, "png", json_object_new_string(letters));
        pp_task_event(
            task, "picture",
            json_object_to_json_string_ext(event, JSON_C_TO_STRING_NOSLASHESCAPE));
    }
    json_object_put(event);
    free(letters);
}

bool pp_stream_render(struct pp_task *task)
{
    struct pp_program_words words = {0};
    struct json_object *room = NULL;
    char size[24], samples[12];
    if (!task->state && !begin_render(task))
        return true;
    struct render *render = task->state;
    int pass = render->pass, divisor = passes[pass].divisor;
    bool good = pp_program_words_make(&words, task);
    if (good) {
        snprintf(size, sizeof size, "%dx%d", render->width / divisor,
                 render->height / divisor);
        snprintf(samples, sizeof samples, "%d", passes[pass].samples);
        pp_program_words_add_option(&words, "size", size);
        pp_program_words_add_option(&words, "samples", samples);
        json_object_object_get_ex(task->body, "room", &room);
        struct pp_child_result result =
            pp_child_run(task, words.list, json_object_get_string(room),
                         (size_t)json_object_get_string_len(room));
        good = result.end == PP_CHILD_DONE && result.status == 0;
        if (good)
            send_picture(task, &result, pass, size);
        else if (result.end != PP_CHILD_CANCELLED)
            pp_task_fail(task, MHD_HTTP_UNPROCESSABLE_CONTENT, "%s",
                         pp_child_sentence(&result));
        free(result.output);
        free(result.errors);
    }
    pp_program_words_clear(&words);
    return !good || ++render->pass == PASSES;
}
