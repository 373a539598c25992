/* asked_room.c - see asked_room.h. */
#include "serve/answers/asked_room.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "serve/answers/mistake_place.h"

/* Limits for a request. Larger rooms require the command line. */
enum {
    POINTS_MOST = 5000,
    OPENINGS_MOST = 200,
    OBJECTS_MOST = 500,
};
static const double work_most = 3e6; /* points × (openings + 1) × (objects + 1) */

static const char member_text[] = "expected { \"room\": TEXT, \"options\": { ... } }";

static struct json_object *options_of(const struct pp_task *task)
{
    struct json_object *options = NULL;
    json_object_object_get_ex(task->body, "options", &options);
    return options;
}

bool pp_asked_room_options(struct pp_task *task, const char *const *names)
{
    struct json_object *options = options_of(task);
    if (options && !json_object_is_type(options, json_type_object)) {
        pp_task_fail(task, MHD_HTTP_BAD_REQUEST, "%s", member_text);
        return false;
    }
    if (!options)
        return true;
    json_object_object_foreach(options, key, value)
    {
        const char *const *name = names;
        (void)value;
        while (*name && strcmp(*name, key) != 0)
            name++;
        if (!*name) {
            pp_task_fail(task, MHD_HTTP_BAD_REQUEST,
                         "there is no option \"%.60s\" of %s", key, task->command);
            return false;
        }
    }
    return true;
}

bool pp_asked_room_option(struct json_object **option, struct pp_task *task,
                          const char *name, enum json_type type)
{
    struct json_object *options = options_of(task);
    *option = NULL;
    if (!options || !json_object_object_get_ex(options, name, option) || !*option)
        return true;
    enum json_type given = json_object_get_type(*option);
    if (given == type || (type == json_type_double && given == json_type_int))
        return true;
    pp_task_fail(task, MHD_HTTP_BAD_REQUEST, "%s is a %s; expected a %s", name,
                 json_type_to_name(given), json_type_to_name(type));
    return false;
}

bool pp_asked_room_number(double *number, struct pp_task *task, const char *name,
                          double usual, double least, double most)
{
    struct json_object *option;
    *number = usual;
    if (!pp_asked_room_option(&option, task, name, json_type_double))
        return false;
    if (option)
        *number = json_object_get_double(option);
    if (*number >= least && *number <= most)
        return true;
    pp_task_fail(task, MHD_HTTP_BAD_REQUEST, "%s is %g; expected %g to %g", name,
                 *number, least, most);
    return false;
}

bool pp_asked_room_sky(struct pp_task *task, const char *sky)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyz0123456789-,.+ ";
    if (!sky
        || (strncmp(sky, "picture", 7) != 0 && strspn(sky, letters) == strlen(sky)))
        return true;
    pp_task_fail(
        task, MHD_HTTP_BAD_REQUEST,
        "sky: expected a sky that needs no file, such as overcast or iso-12,40,180");
    return false;
}

static int count_of(const char *text, const char *word)
{
    int count = 0;
    for (; (text = strstr(text, word)); text += strlen(word))
        count++;
    return count;
}

static bool is_too_large(struct pp_task *task, const struct pp_asked_room *asked)
{
    int openings = count_of(asked->text, "<window")
                   + count_of(asked->text, "<rooflight")
                   + count_of(asked->text, "<opening");
    int objects = count_of(asked->text, "<block") + count_of(asked->text, "<surface")
                  + count_of(asked->text, "<furniture")
                  + count_of(asked->text, "<partition")
                  + count_of(asked->text, "<column") + count_of(asked->text, "<face");
    int points = asked->study ? pp_study_point_count(asked->study) : 0;
    double work = (double)points * (openings + 1) * (objects + 1);
    if (openings <= OPENINGS_MOST && objects <= OBJECTS_MOST && points <= POINTS_MOST
        && work <= work_most)
        return false;
    pp_task_fail(task, MHD_HTTP_UNPROCESSABLE_CONTENT,
                 "the room has %d points, %d openings and %d objects; this server "
                 "accepts at most %d, %d and %d, and fewer if all three numbers are "
                 "large. Use the pepperpot command instead",
                 points, openings, objects, POINTS_MOST, OPENINGS_MOST, OBJECTS_MOST);
    return true;
}

struct json_object *pp_asked_room_mistakes(const struct pp_asked_room *asked)
{
    struct json_object *list = json_object_new_array();
    for (int i = 0; list && i < pp_mistakes_count(asked->mistakes); i++) {
        const char *sentence = pp_mistakes_text(asked->mistakes, i);
        struct pp_mistake_place place = pp_mistake_place_find(
            asked->text, asked->length, pp_mistakes_line(asked->mistakes, i), sentence);
        struct json_object *item = json_object_new_object();
        if (!item)
            break;
        json_object_object_add(item, "line", json_object_new_int(place.line));
        json_object_object_add(item, "column", json_object_new_int(place.column));
        json_object_object_add(item, "end-line", json_object_new_int(place.end_line));
        json_object_object_add(item, "end-column",
                               json_object_new_int(place.end_column));
        json_object_object_add(item, "text", json_object_new_string(sentence));
        json_object_array_add(list, item);
    }
    return list;
}

/* Answers with the errors in the room file. */
static void fail_mistakes(struct pp_task *task, const struct pp_asked_room *asked,
                          const struct pp_error *err)
{
    if (pp_mistakes_count(asked->mistakes) == 0) {
        pp_task_fail_with(task, err);
        return;
    }
    struct json_object *object = json_object_new_object();
    if (object) {
        json_object_object_add(
            object, "error",
            json_object_new_string(pp_mistakes_text(asked->mistakes, 0)));
        json_object_object_add(object, "mistakes", pp_asked_room_mistakes(asked));
    }
    pp_task_answer_json(task, MHD_HTTP_UNPROCESSABLE_CONTENT, object);
}

/* Creates the study of the room with that name; NULL: the first room. PP_BAD_INPUT if
 * there is no such room. */
static enum pp_status choose_room(struct pp_asked_room *asked, const char *name,
                                  const char *sky, struct pp_error *err)
{
    int count = pp_building_room_count(asked->building);
    for (int i = 0; i < count; i++) {
        enum pp_status status = pp_study_create(&asked->study, asked->building, i, sky,
                                                asked->mistakes, err);
        if (status != PP_OK || !name)
            return status;
        const char *own = pp_study_name(asked->study);
        if (own && strcmp(own, name) == 0)
            return status;
        pp_study_destroy(asked->study);
        asked->study = NULL;
    }
    err->status = PP_BAD_INPUT;
    strcpy(err->message, "there is no room with that name");
    return PP_BAD_INPUT;
}

/* Replaces the room's points by a list such as [[x, y], [x, y, z], ...]. */
static bool set_points(struct pp_asked_room *asked, struct pp_task *task,
                       struct json_object *points)
{
    size_t count = json_object_array_length(points);
    struct pp_error err = {0};
    if (count < 1 || count > POINTS_MOST) {
        pp_task_fail(task, MHD_HTTP_BAD_REQUEST,
                     "there are %zu points; expected 1 to %d", count, POINTS_MOST);
        return false;
    }
    double(*list)[3] = calloc(count, sizeof *list);
    bool good = list != NULL;
    for (size_t i = 0; i < count && good; i++) {
        struct json_object *point = json_object_array_get_idx(points, i);
        size_t numbers = json_object_is_type(point, json_type_array)
                             ? json_object_array_length(point)
                             : 0;
        good = numbers == 2 || numbers == 3;
        list[i][2] = NAN;
        for (size_t k = 0; k < numbers && good; k++) {
            struct json_object *number = json_object_array_get_idx(point, k);
            good = json_object_is_type(number, json_type_double)
                   || json_object_is_type(number, json_type_int);
            list[i][k] = json_object_get_double(number);
        }
    }
    if (!good)
        pp_task_fail(task, MHD_HTTP_BAD_REQUEST,
                     "points: expected [[x, y], [x, y, z]]");
    else if (pp_study_set_points(asked->study, (const double(*)[3])list, (int)count,
                                 &err)
             != PP_OK) {
        pp_task_fail_with(task, &err);
        good = false;
    }
    free(list);
    return good;
}

bool pp_asked_room_open(struct pp_asked_room *asked, struct pp_task *task)
{
    struct json_object *room = NULL, *name, *sky, *points;
    struct pp_error err = {0};
    *asked = (struct pp_asked_room){0};
    json_object_object_get_ex(task->body, "room", &room);
    if (!json_object_is_type(room, json_type_string)) {
        pp_task_fail(task, MHD_HTTP_BAD_REQUEST, "%s", member_text);
        return false;
    }
    if (!pp_asked_room_option(&name, task, "room", json_type_string)
        || !pp_asked_room_option(&sky, task, "sky", json_type_string)
        || !pp_asked_room_sky(task, json_object_get_string(sky))
        || !pp_asked_room_option(&points, task, "points", json_type_array))
        return false;
    asked->text = json_object_get_string(room);
    asked->length = (size_t)json_object_get_string_len(room);
    asked->mistakes = pp_mistakes_create("room");
    if (!asked->mistakes) {
        pp_task_fail(task, MHD_HTTP_INTERNAL_SERVER_ERROR, "out of memory");
        return false;
    }
    if (is_too_large(task, asked))
        return false;
    enum pp_status status = pp_building_parse(&asked->building, asked->text,
                                              asked->length, asked->mistakes, &err);
    if (status == PP_OK)
        status = choose_room(asked, json_object_get_string(name),
                             json_object_get_string(sky), &err);
    if (status != PP_OK) {
        fail_mistakes(task, asked, &err);
        return false;
    }
    pp_study_stop_when(asked->study, pp_task_is_given_up, task);
    if (points && !set_points(asked, task, points))
        return false;
    return !is_too_large(task, asked);
}

void pp_asked_room_clear(struct pp_asked_room *asked)
{
    pp_study_destroy(asked->study);
    pp_building_destroy(asked->building);
    pp_mistakes_destroy(asked->mistakes);
    *asked = (struct pp_asked_room){0};
}

bool pp_asked_room_check(struct pp_task *task)
{
    struct pp_asked_room asked = {0};
    struct json_object *options = NULL;
    json_object_object_get_ex(task->body, "options", &options);
    json_object_get(options);
    json_object_object_del(task->body, "options");
    bool good = pp_asked_room_open(&asked, task);
    pp_asked_room_clear(&asked);
    if (options)
        json_object_object_add(task->body, "options", options);
    return good;
}
