/* program_words.c - see program_words.h. */
#include "serve/work/program_words.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "serve/answers/asked_room.h"
#include "serve/stores/weather_store.h"

/* Commands that a request may run, with the options that it may set, separated by
 * blanks, and the output formats, default first. No option in this list may name a
 * file; "weather" is the hash of an uploaded file. */
static const struct {
    const char *command, *options, *formats;
} commands[] = {
    {"df",
     " methods points sky room state explain advise formula external simulate error "
     "samples time seed bands no-bands margin ",
     " json text csv "},
    {"chart",
     " methods points sky room state paper orientation dpi log linear line fill "
     "vsc-point-french glazed fine receiver viewing-distance number glazing slope "
     "which "
     "inclined unsolved window lens diameter show scale mirror-box latitude longitude "
     "time-zone hours days summer-time simulate error samples time seed weather ",
     " svg pdf png "},
    {"assess",
     " criteria for place median-diffuse room state vsc-point-french by-hand simulate "
     "error samples time seed mirror-image external weather ",
     " json text csv "},
    {"size",
     " target for by change wall window obstruction envelope of keep enough "
     "window-name "
     "highest vsc-point-french points sky room state by-hand simulate error samples "
     "time "
     "seed ",
     " json text csv "},
    {"availability",
     " illuminance methods points sky room state latitude longitude time-zone hours "
     "days "
     "summer-time simulate error samples time seed weather ",
     " json text csv "},
    {"annual",
     " weather sun-shift leap-day blinds patches exact-sky hours days summer-time "
     "illuminance lighting methods df explain when points room state error samples "
     "time seed ",
     " json text csv "},
    {"report",
     " criteria for place median-diffuse room state vsc-point-french by-hand simulate "
     "error samples time seed mirror-image weather ",
     " html pdf "},
    {"render",
     " view from towards direction up angle across size quantity samples engine "
     "windows "
     "filter external sky room state seed exposure false-colour range linear levels "
     "no-contours grid dpi paper ",
     " png "},
};
enum { COMMANDS = sizeof commands / sizeof *commands };

static const struct {
    const char *format, *type;
} types[] = {
    {"json", "application/json"},         {"text", "text/plain; charset=utf-8"},
    {"csv", "text/csv; charset=utf-8"},   {"svg", "image/svg+xml"},
    {"pdf", "application/pdf"},           {"png", "image/png"},
    {"html", "text/html; charset=utf-8"},
};

void pp_program_words_add(struct pp_program_words *words, const char *word)
{
    if (words->count < PP_CHILD_WORDS_MOST)
        words->list[words->count++] = word;
    words->list[words->count] = NULL;
}

void pp_program_words_add_option(struct pp_program_words *words, const char *name,
                                 const char *value)
{
    size_t size = strlen(name) + strlen(value) + 4;
    char *word = words->owned_count < PP_CHILD_WORDS_MOST ? malloc(size) : NULL;
    if (!word)
        return;
    snprintf(word, size, "--%s%s%s", name, *value ? "=" : "", value);
    words->owned[words->owned_count++] = word;
    pp_program_words_add(words, word);
}

void pp_program_words_clear(struct pp_program_words *words)
{
    for (int i = 0; i < words->owned_count; i++)
        free(words->owned[i]);
    words->owned_count = 0;
}

/* True if the word is in a list of words separated by blanks. */
static bool is_listed(const char *list, const char *word)
{
    size_t length = strlen(word);
    for (const char *at = list; length > 0 && (at = strstr(at, word)); at += length)
        if (at[-1] == ' ' && at[length] == ' ')
            return true;
    return false;
}

/* Text of a list entry. json-c represents JSON's null by a null pointer. */
static const char *text_of_entry(struct json_object *entry)
{
    return entry ? json_object_get_string(entry) : "null";
}

/* Writes a list of points or numbers in the form used on the command line: "1.5,2
 * 1.5,3". */
static void write_list(FILE *out, struct json_object *list, const char *between)
{
    for (size_t i = 0; i < json_object_array_length(list); i++) {
        struct json_object *entry = json_object_array_get_idx(list, i);
        fputs(i > 0 ? between : "", out);
        if (json_object_is_type(entry, json_type_array))
            write_list(out, entry, ",");
        else
            fputs(text_of_entry(entry), out);
    }
}

/* Adds an option once for each entry of a list. */
static void add_repeated(struct pp_program_words *words, const char *name,
                         struct json_object *list)
{
    for (size_t i = 0; i < json_object_array_length(list); i++)
        pp_program_words_add_option(words, name,
                                    text_of_entry(json_object_array_get_idx(list, i)));
}

/* Adds an option as an argument. If the value is not valid, returns false and sets the
 * error answer. */
static bool add_option(struct pp_program_words *words, struct pp_task *task,
                       const char *name, struct json_object *value)
{
    switch (json_object_get_type(value)) {
    case json_type_null:
        return true;
    case json_type_boolean:
        if (json_object_get_boolean(value))
            pp_program_words_add_option(words, name, "");
        return true;
    case json_type_int:
    case json_type_double:
        pp_program_words_add_option(words, name, json_object_get_string(value));
        return true;
    case json_type_string: {
        const char *text = json_object_get_string(value);
        char *path = NULL; /* of a weather file */
        if (*text == '\0' || strlen(text) > 2000) {
            pp_task_fail(task, MHD_HTTP_BAD_REQUEST, "%s is empty or too long", name);
            return false;
        }
        if (strcmp(name, "sky") == 0 && !pp_asked_room_sky(task, text))
            return false;
        if (strcmp(name, "weather") == 0
            && !(path = pp_weather_store_path(task->server->weather, text))) {
            pp_task_fail(task, MHD_HTTP_NOT_FOUND,
                         "the server has no weather file with that hash; upload it to "
                         "/api/weather");
            return false;
        }
        pp_program_words_add_option(words, name, path ? path : text);
        free(path);
        return true;
    }
    case json_type_array: {
        /* --lighting is repeated instead, since its values contain commas. */
        if (strcmp(name, "lighting") == 0) {
            add_repeated(words, name, value);
            return true;
        }
        char *text = NULL;
        size_t length;
        FILE *out = open_memstream(&text, &length);
        if (!out)
            return false;
        write_list(out, value, strcmp(name, "points") == 0 ? " " : ",");
        if (fclose(out) == 0)
            pp_program_words_add_option(words, name, text);
        free(text);
        return true;
    }
    default:
        pp_task_fail(task, MHD_HTTP_BAD_REQUEST,
                     "%s is an object; expected a single value", name);
        return false;
    }
}

/* Sets the output format and its media type. If the format is not available, returns
 * false and sets the error answer. */
static bool add_format(struct pp_program_words *words, struct pp_task *task,
                       const char *formats, const char *format)
{
    char first[8];
    if (!format) {
        snprintf(first, sizeof first, "%.*s", (int)strcspn(formats + 1, " "),
                 formats + 1);
        format = first;
    }
    for (size_t i = 0; i < sizeof types / sizeof *types; i++)
        if (strcmp(types[i].format, format) == 0 && is_listed(formats, format)) {
            words->type = types[i].type;
            pp_program_words_add_option(words, "format", types[i].format);
            return true;
        }
    pp_task_fail(task, MHD_HTTP_BAD_REQUEST, "format: expected one of%s", formats);
    return false;
}

bool pp_program_words_make(struct pp_program_words *words, struct pp_task *task)
{
    struct json_object *options = NULL;
    const char *format = NULL;
    int command = 0;
    *words = (struct pp_program_words){0};
    while (command < COMMANDS && strcmp(commands[command].command, task->command) != 0)
        command++;
    if (command == COMMANDS) {
        pp_task_fail(task, MHD_HTTP_BAD_REQUEST, "there is no command \"%.40s\"",
                     task->command);
        return false;
    }
    pp_program_words_add(words, "pepperpot");
    pp_program_words_add(words, commands[command].command);
    json_object_object_get_ex(task->body, "options", &options);
    if (options && !json_object_is_type(options, json_type_object)) {
        pp_task_fail(task, MHD_HTTP_BAD_REQUEST, "options: expected an object");
        return false;
    }
    if (options) {
        if (json_object_object_length(options) > 30) {
            pp_task_fail(task, MHD_HTTP_BAD_REQUEST, "there are too many options");
            return false;
        }
        json_object_object_foreach(options, name, value)
        {
            if (strcmp(name, "format") == 0
                && json_object_is_type(value, json_type_string)) {
                format = json_object_get_string(value);
            } else if (!is_listed(commands[command].options, name)) {
                pp_task_fail(task, MHD_HTTP_BAD_REQUEST,
                             "there is no option \"%.60s\" of %s", name, task->command);
                return false;
            } else if (!add_option(words, task, name, value)) {
                return false;
            }
        }
    }
    if (!add_format(words, task, commands[command].formats, format))
        return false;
    pp_program_words_add(words, "--quiet");
    pp_program_words_add(words, "--output=-");
    if (task->kind[0])
        pp_program_words_add(words, task->kind);
    pp_program_words_add(words, "-");
    return true;
}
