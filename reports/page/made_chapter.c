/* made_chapter.c - see made_chapter.h. */
#include "reports/page/made_chapter.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "methods/method.h"
#include "model/base/array.h"

/* ---- the methods ---- */

/* True if `column` belongs to the method, or to a pair that includes the method
 * ("exact+bre" for "exact"). */
static bool is_part(const char *column, const char *method)
{
    size_t length = strlen(method);
    for (const char *at = column; (at = strstr(at, method)) != NULL; at += length)
        if ((at == column || at[-1] == '+') && (at[length] == '+' || !at[length]))
            return true;
    return false;
}

/* True if any room has a value by the method. */
static bool is_used(const struct pp_assessments *all, const char *method)
{
    for (int i = 0; i < all->count; i++)
        for (int k = 0; k < all->list[i].report.column_count; k++) {
            const struct pp_column *column = &all->list[i].report.columns[k];
            if (isfinite(column->average.value) && is_part(column->name, method))
                return true;
        }
    return false;
}

static void put_method(struct pp_document *document, const struct pp_method *method)
{
    char contents[128];
    pp_allowance_words(contents, sizeof contents, method->allowances);
    pp_document_row(document, PP_ROW_CELLS);
    pp_document_cell(document, PP_TONE_PLAIN, "%s", method->name);
    pp_document_cell(document, PP_TONE_PLAIN, "%s [%s]", method->summary,
                     method->source);
    pp_document_cell(document, PP_TONE_PLAIN, "%s", contents);
}

static void put_methods(struct pp_document *document, const struct pp_assessments *all)
{
    bool any = false;
    for (int i = 0; pp_methods[i]; i++) {
        if (!is_used(all, pp_methods[i]->name))
            continue;
        if (!any) {
            pp_document_heading(document, 3, "Hand methods");
            pp_document_table(document);
            pp_document_column(document, PP_COLUMN_LABELS, "method");
            pp_document_column(document, PP_COLUMN_WORDS, "description");
            pp_document_column(document, PP_COLUMN_WORDS,
                               "allowances in published "
                               "figures");
        }
        any = true;
        put_method(document, pp_methods[i]);
    }
    if (any)
        pp_document_paragraph(document, PP_TONE_SOFT,
                              "Losses for glass, frames and dirt are applied only "
                              "once in this report. Losses already included in a "
                              "method's published figures are not applied again.");
}

/* ---- the sources ---- */

struct works {
    const char *(*find)(const char *place, const char **key);
    struct work {
        const char *key, *work;
    } * list;
    int count;
    enum pp_status status;
    struct pp_error *err;
};

static void add_work(struct works *works, const char *place)
{
    const char *key, *work = works->find(place, &key);
    for (int i = 0; i < works->count; i++)
        if (work && works->list[i].key == key)
            return;
    if (!work || works->status != PP_OK)
        return;
    works->status =
        pp_array_append(&works->list, works->count, sizeof *works->list, works->err);
    if (works->status == PP_OK)
        works->list[works->count++] = (struct work){key, work};
}

/* Adds the publications whose keys are in square brackets. Keys in the same brackets
 * are separated by ", ". */
static void add_works(void *closure, const char *text)
{
    for (const char *open = text; (open = strchr(open, '[')) != NULL; open++) {
        size_t length = strcspn(open + 1, "[]");
        char places[128];
        if (open[1 + length] != ']' || length >= sizeof places)
            continue;
        snprintf(places, sizeof places, "%.*s", (int)length, open + 1);
        for (char *place = places, *next; place; place = next) {
            next = strstr(place, ", ");
            if (next) {
                *next = '\0';
                next += 2;
            }
            add_work(closure, place);
        }
    }
}

static int by_key(const void *a, const void *b)
{
    return strcmp(((const struct work *)a)->key, ((const struct work *)b)->key);
}

static enum pp_status put_sources(struct pp_document *document,
                                  const struct pp_site_report *report,
                                  struct pp_error *err)
{
    struct works works = {.find = report->work_of, .err = err};
    pp_document_texts(document, add_works, &works);
    if (works.status == PP_OK && works.count > 0) {
        qsort(works.list, (size_t)works.count, sizeof *works.list, by_key);
        pp_document_heading(document, 3, "Sources");
        pp_document_table(document);
        pp_document_column(document, PP_COLUMN_LABELS, "%s", "");
        pp_document_column(document, PP_COLUMN_WORDS, "%s", "");
    }
    for (int i = 0; i < works.count && works.status == PP_OK; i++) {
        pp_document_row(document, PP_ROW_CELLS);
        pp_document_cell(document, PP_TONE_PLAIN, "[%s]", works.list[i].key);
        pp_document_cell(document, PP_TONE_PLAIN, "%s", works.list[i].work);
    }
    free(works.list);
    return works.status;
}

/* ---- the chapter ---- */

static void say_engine(struct pp_document *document,
                       const struct pp_study_options *options)
{
    if (options->simulate)
        pp_document_paragraph(
            document, PP_TONE_PLAIN,
            "Simulated figures are followed by ± one standard error; the seed is %llu. "
            "The same file, options and seed give the same figures.",
            (unsigned long long)options->seed);
    else
        pp_document_paragraph(
            document, PP_TONE_PLAIN,
            "Nothing was simulated: all figures are from hand methods.");
}

enum pp_status pp_made_chapter(struct pp_document *document,
                               const struct pp_site_report *report,
                               struct pp_error *err)
{
    pp_document_heading(document, 2, "How this report was made");
    pp_document_paragraph(document, PP_TONE_PLAIN,
                          "Made by pepperpot %s:", report->version);
    pp_document_paragraph(document, PP_TONE_CODE, "%s", report->made_by);
    say_engine(document, report->all->options);
    put_methods(document, report->all);
    enum pp_status status = pp_document_status(document, err);
    return status == PP_OK ? put_sources(document, report, err) : status;
}
