/* selection.c - reads lists of methods, such as "exact+bre,average-df". */
#include "methods/selection.h"

#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/base/text.h"

static const char default_selection[] = "exact+bre,brs-table+bre,average-df";

static enum pp_status add_selected_method(struct pp_selection *selection,
                                          const struct pp_method *method,
                                          const struct pp_method *internal,
                                          struct pp_error *err)
{
    for (int i = 0; i < selection->count; i++)
        if (selection->choices[i].method == method
            && selection->choices[i].internal == internal)
            return PP_OK;
    enum pp_status status = pp_array_append(&selection->choices, selection->count,
                                            sizeof *selection->choices, err);
    if (status == PP_OK)
        selection->choices[selection->count++] = (struct pp_choice){method, internal};
    return status;
}

/* Fails with the names of all methods and the most similar one. */
static enum pp_status unknown(const char *name, struct pp_error *err)
{
    enum { MOST = 32 };
    const char *names[MOST + 2];
    int count = 0;
    for (; pp_methods[count] && count < MOST; count++)
        names[count] = pp_methods[count]->name;
    names[count++] = "default";
    names[count++] = "all";
    char written[64], known[512], question[128];
    pp_text_excerpt(written, sizeof written, name);
    pp_text_list_names(known, sizeof known, names, count);
    pp_text_did_you_mean(question, sizeof question, "\"",
                         pp_text_nearest(name, names, count), "\"");
    if (question[0])
        return pp_fail(
            err, PP_BAD_INPUT,
            "unknown method \"%s\" (%s); expected %s, or a pair such as exact+bre",
            written, question, known);
    return pp_fail(err, PP_BAD_INPUT,
                   "unknown method \"%s\"; expected %s, or a pair such as exact+bre",
                   written, known);
}

static enum pp_status find_method(const struct pp_method **method, const char *name,
                                  struct pp_error *err)
{
    *method = pp_method_find(name);
    return *method ? PP_OK : unknown(name, err);
}

static enum pp_status add_pair(struct pp_selection *selection, const char *direct_name,
                               const char *internal_name, struct pp_error *err)
{
    const struct pp_method *direct, *internal;
    enum pp_status status = find_method(&direct, direct_name, err);
    if (status == PP_OK)
        status = find_method(&internal, internal_name, err);
    if (status != PP_OK)
        return status;
    if (direct->gives != PP_GIVES_DIRECT)
        return pp_fail(err, PP_BAD_INPUT,
                       "\"%s+%s\": %s does not give the direct component; the first "
                       "method of a pair must give it",
                       direct_name, internal_name, direct_name);
    if (internal->gives != PP_GIVES_INTERNAL)
        return pp_fail(err, PP_BAD_INPUT,
                       "\"%s+%s\": %s does not give the internally reflected "
                       "component; the second method of a pair must give it",
                       direct_name, internal_name, internal_name);
    return add_selected_method(selection, direct, internal, err);
}

/* Adds every direct method, except those available only by name, with bre; every
 * internal one with exact; and all whole ones. */
static enum pp_status add_all(struct pp_selection *selection, struct pp_error *err)
{
    const struct pp_method *exact = pp_method_find("exact");
    const struct pp_method *bre = pp_method_find("bre");
    enum pp_status status = PP_OK;
    for (int i = 0; pp_methods[i] && status == PP_OK; i++)
        if (pp_methods[i]->gives == PP_GIVES_DIRECT && !pp_methods[i]->by_name)
            status = add_selected_method(selection, pp_methods[i], bre, err);
    for (int i = 0; pp_methods[i] && status == PP_OK; i++)
        if (pp_methods[i]->gives == PP_GIVES_INTERNAL)
            status = add_selected_method(selection, exact, pp_methods[i], err);
    for (int i = 0; pp_methods[i] && status == PP_OK; i++)
        if (pp_methods[i]->gives == PP_GIVES_WHOLE && !pp_methods[i]->by_name)
            status = add_selected_method(selection, pp_methods[i], NULL, err);
    return status;
}

static enum pp_status add_list(struct pp_selection *selection, char *list,
                               struct pp_error *err);

static enum pp_status add_item(struct pp_selection *selection, char *item,
                               struct pp_error *err)
{
    char *plus = strchr(item, '+');
    if (plus) {
        *plus = '\0';
        return add_pair(selection, item, plus + 1, err);
    }
    if (strcmp(item, "all") == 0)
        return add_all(selection, err);
    if (strcmp(item, "default") == 0) {
        selection->usual = true;
        char list[sizeof default_selection];
        memcpy(list, default_selection, sizeof list);
        return add_list(selection, list, err);
    }
    const struct pp_method *method;
    enum pp_status status = find_method(&method, item, err);
    return status == PP_OK ? add_selected_method(selection, method, NULL, err) : status;
}

/* Adds the methods of a list separated by commas; writes into the list. */
static enum pp_status add_list(struct pp_selection *selection, char *list,
                               struct pp_error *err)
{
    enum pp_status status = PP_OK;
    while (list && status == PP_OK) {
        char *item = strsep(&list, ",");
        item += strspn(item, " ");
        item[strcspn(item, " ")] = '\0';
        status = add_item(selection, item, err);
    }
    return status;
}

enum pp_status pp_selection_parse(struct pp_selection *selection, const char *text,
                                  struct pp_error *err)
{
    *selection = (struct pp_selection){.usual = !text};
    char *list = strdup(text ? text : default_selection);
    if (!list)
        return pp_fail_memory(err);
    enum pp_status status = add_list(selection, list, err);
    free(list);
    if (status != PP_OK)
        pp_selection_clear(selection);
    return status;
}

void pp_selection_clear(struct pp_selection *selection)
{
    free(selection->choices);
    *selection = (struct pp_selection){0};
}

enum pp_status pp_selection_include(struct pp_selection *selection,
                                    const struct pp_method *method,
                                    struct pp_error *err)
{
    for (int i = 0; i < selection->count; i++)
        if (selection->choices[i].method == method
            || selection->choices[i].internal == method)
            return PP_OK;
    switch (method->gives) {
    case PP_GIVES_DIRECT:
        return add_selected_method(selection, method, pp_method_find("bre"), err);
    case PP_GIVES_INTERNAL:
        return add_selected_method(selection, pp_method_find("exact"), method, err);
    case PP_GIVES_WHOLE:
        break;
    }
    return add_selected_method(selection, method, NULL, err);
}

enum pp_status pp_selection_check(const char *selection, struct pp_error *err)
{
    struct pp_selection parsed;
    enum pp_status status = pp_selection_parse(&parsed, selection, err);
    if (status == PP_OK)
        pp_selection_clear(&parsed);
    return status;
}
