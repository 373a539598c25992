/* answer_program.c - see answer_program.h. */
#include "serve/answers/answer_program.h"

#include <stdlib.h>
#include <string.h>

#include "serve/answers/asked_room.h"
#include "serve/work/program_words.h"

/* Answers with the output of the child process, or with its error. Takes ownership of
 * the output. */
static void answer_child(struct pp_task *task, struct pp_child_result *result,
                         const char *type)
{
    if (result->end == PP_CHILD_LIMIT)
        pp_task_fail(task, MHD_HTTP_GATEWAY_TIMEOUT,
                     "the command took more than %d s, or its result was too large",
                     PP_CHILD_SECONDS_MOST);
    else if (result->end == PP_CHILD_FAILED || result->status == 3)
        pp_task_fail(task, MHD_HTTP_INTERNAL_SERVER_ERROR, "%s",
                     pp_child_sentence(result));
    else if (result->end == PP_CHILD_DONE && result->status != 0)
        pp_task_fail(task,
                     result->status == 2 ? MHD_HTTP_BAD_REQUEST
                                         : MHD_HTTP_UNPROCESSABLE_CONTENT,
                     "%s", pp_child_sentence(result));
    else if (result->end == PP_CHILD_DONE) {
        pp_task_answer(task, MHD_HTTP_OK, type, result->output, result->length);
        result->output = NULL;
    }
    free(result->output);
    free(result->errors);
}

bool pp_answer_program(struct pp_task *task)
{
    struct pp_program_words words = {0};
    struct json_object *room = NULL;
    if (pp_asked_room_check(task) && pp_program_words_make(&words, task)) {
        json_object_object_get_ex(task->body, "room", &room);
        struct pp_child_result result =
            pp_child_run(task, words.list, json_object_get_string(room),
                         (size_t)json_object_get_string_len(room));
        answer_child(task, &result, words.type);
    }
    pp_program_words_clear(&words);
    return true;
}

/* Converts { "gbxml": "<gbXML ...>" } to a room file. */
bool pp_answer_program_import(struct pp_task *task)
{
    static const char *const words[] = {"pepperpot", "import", "-", NULL};
    struct json_object *text = NULL;
    json_object_object_get_ex(task->body, "gbxml", &text);
    const char *bytes = json_object_is_type(text, json_type_string)
                            ? json_object_get_string(text)
                            : NULL;
    const char *first = bytes ? bytes + strspn(bytes, " \t\r\n\xEF\xBB\xBF") : "";
    /* Only gbXML is accepted, because other scene formats may refer to files on the
     * server. */
    if (*first != '<' || !strstr(first, "<gbXML")) {
        pp_task_fail(task, MHD_HTTP_UNPROCESSABLE_CONTENT,
                     "expected { \"gbxml\": TEXT } with a gbXML file");
        return true;
    }
    struct pp_child_result result = pp_child_run(task, words, first, strlen(first));
    answer_child(task, &result, "application/xml");
    return true;
}
