/* mistakes.c - see mistakes.h. */
#include "model/base/mistakes.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"

void pp_mistakes_init(struct pp_mistakes *mistakes, const char *file)
{
    *mistakes = (struct pp_mistakes){0};
    mistakes->file = strdup(file);
    mistakes->truncated = !mistakes->file;
}

void pp_mistakes_clear(struct pp_mistakes *mistakes)
{
    for (int i = 0; i < mistakes->count; i++)
        free(mistakes->list[i].text);
    free(mistakes->list);
    free(mistakes->file);
    *mistakes = (struct pp_mistakes){0};
}

static bool is_noted(const struct pp_mistakes *mistakes, int line, const char *text)
{
    for (int i = 0; i < mistakes->count; i++)
        if (mistakes->list[i].line == line && strcmp(mistakes->list[i].text, text) == 0)
            return true;
    return false;
}

void pp_mistakes_add(struct pp_mistakes *mistakes, int line, const char *format, ...)
{
    if (mistakes->count == PP_MISTAKES_MOST && mistakes->truncated)
        return;
    char *text = NULL;
    va_list args;
    va_start(args, format);
    int length = vasprintf(&text, format, args);
    va_end(args);
    if (length < 0) {
        mistakes->truncated = true;
        return;
    }
    if (is_noted(mistakes, line, text)) {
        free(text);
        return;
    }
    if (mistakes->count == PP_MISTAKES_MOST) {
        mistakes->truncated = true;
        free(text);
        return;
    }

    if (pp_array_append(&mistakes->list, mistakes->count, sizeof *mistakes->list, NULL)
        != PP_OK) {
        mistakes->truncated = true;
        free(text);
        return;
    }
    mistakes->list[mistakes->count++] = (struct pp_input_mistake){line, text};
}

/* Insertion sort, which is stable. There are at most a thousand mistakes, mostly in
 * order. */
void pp_mistakes_sort(struct pp_mistakes *mistakes)
{
    for (int i = 1; i < mistakes->count; i++) {
        struct pp_input_mistake moved = mistakes->list[i];
        int k = i;
        for (; k > 0 && mistakes->list[k - 1].line > moved.line; k--)
            mistakes->list[k] = mistakes->list[k - 1];
        mistakes->list[k] = moved;
    }
}

struct pp_mistakes *pp_mistakes_create(const char *file)
{
    struct pp_mistakes *mistakes = malloc(sizeof *mistakes);
    if (mistakes)
        pp_mistakes_init(mistakes, file);
    return mistakes;
}

void pp_mistakes_destroy(struct pp_mistakes *mistakes)
{
    if (mistakes)
        pp_mistakes_clear(mistakes);
    free(mistakes);
}

int pp_mistakes_count(const struct pp_mistakes *mistakes)
{
    return mistakes->count;
}

int pp_mistakes_line(const struct pp_mistakes *mistakes, int index)
{
    return mistakes->list[index].line;
}

const char *pp_mistakes_text(const struct pp_mistakes *mistakes, int index)
{
    return mistakes->list[index].text;
}
