/* work_results.c - one slot per index; results before `next` are collected. */
#include "model/base/work_results.h"

#include <stdlib.h>

/* A rank counts as lost if it has sent nothing for longer than silence_s plus
 * silence_times the longest computing time of any index. Its indices are then computed
 * again; results that are already collected stay. */
static const double silence_s = 0.5, silence_times = 3.0;

struct slot {
    char *bytes; /* NULL: not done, failed, or collected */
    size_t length;
    double since_s; /* time of assignment to `rank` */
    int rank;
    bool done;
};

struct pp_work_results {
    const struct pp_work_queue *queue;
    struct slot *slots; /* one per index, from queue->first */
    double *heard_s;    /* time of the last message, by rank */
    double longest_s;   /* longest known time of an index */
    int next;           /* next index to collect */
    int unassigned;     /* indices from here on are unassigned */
    int end;            /* end of the queue, or first failed index */
    bool stopped;
    enum pp_status status; /* status of the last call of queue->collect */
    struct pp_error err;
    enum pp_status failure; /* error of index `end` */
    struct pp_error why;
};

static struct slot *result_slot(const struct pp_work_results *results, int index)
{
    return &results->slots[index - results->queue->first];
}

enum pp_status pp_work_results_create(struct pp_work_results **results,
                                      const struct pp_work_queue *queue,
                                      struct pp_error *err)
{
    int count = queue->end > queue->first ? queue->end - queue->first : 0;
    struct pp_work_results *made = calloc(1, sizeof *made);
    *results = NULL;
    if (!made)
        return pp_fail_memory(err);
    *made = (struct pp_work_results){
        .queue = queue,
        .slots = calloc((size_t)count + 1, sizeof *made->slots),
        .heard_s = calloc(queue->ranks ? (size_t)queue->ranks->count : 1,
                          sizeof *made->heard_s),
        .next = queue->first,
        .unassigned = queue->first,
        .end = queue->first + count};
    if (!made->slots || !made->heard_s) {
        made->end = made->next;
        pp_work_results_destroy(made);
        return pp_fail_memory(err);
    }
    *results = made;
    return PP_OK;
}

void pp_work_results_destroy(struct pp_work_results *results)
{
    if (!results)
        return;
    for (int i = 0; results->slots && i < results->queue->end - results->queue->first;
         i++)
        free(results->slots[i].bytes);
    free(results->slots);
    free(results->heard_s);
    free(results);
}

void pp_work_results_work(const struct pp_work_queue *queue, int worker, int index,
                          struct pp_work_result *result)
{
    *result = (struct pp_work_result){0};
    result->status = queue->work(queue->data, worker, index, &result->bytes,
                                 &result->length, &result->err);
    if (result->status != PP_OK) {
        free(result->bytes);
        result->bytes = NULL;
        result->length = 0;
    }
}

/* Collects the consecutive results from `next` on. */
static void collect_results(struct pp_work_results *results)
{
    const struct pp_work_queue *queue = results->queue;
    while (results->status == PP_OK && results->next < results->end) {
        struct slot *slot = result_slot(results, results->next);
        if (!slot->done)
            return;
        results->status = queue->collect(queue->data, results->next, slot->bytes,
                                         slot->length, &results->err);
        free(slot->bytes);
        slot->bytes = NULL;
        results->next += results->status == PP_OK;
    }
}

void pp_work_results_enter(struct pp_work_results *results, int index,
                           const struct pp_work_result *result)
{
    const struct pp_work_queue *queue = results->queue;
    struct slot *slot = result_slot(results, index);
    if (slot->done) {
        free(result->bytes);
        return;
    }
    slot->bytes = result->bytes;
    slot->length = result->length;
    slot->done = true;
    if (result->status != PP_OK && index < results->end) {
        results->end = index;
        results->failure = result->status;
        results->why = result->err;
    }
    collect_results(results);
    int count = queue->end - queue->first;
    if (!results->stopped && queue->goes_on)
        results->stopped = !queue->goes_on(
            queue->data, (double)(results->next - queue->first) / count);
}

bool pp_work_results_is_over(const struct pp_work_results *results)
{
    return results->stopped || results->status != PP_OK
           || results->next >= results->end;
}

int pp_work_results_unassigned(const struct pp_work_results *results)
{
    return results->end > results->unassigned ? results->end - results->unassigned : 0;
}

int pp_work_results_assign(struct pp_work_results *results, int rank, int most,
                           double now_s, int *index)
{
    int left = pp_work_results_unassigned(results), count = left < most ? left : most;
    *index = results->unassigned;
    for (int i = 0; i < count; i++) {
        struct slot *slot = result_slot(results, results->unassigned++);
        slot->rank = rank;
        slot->since_s = now_s;
    }
    pp_work_results_heard_from(results, rank, now_s);
    return count;
}

void pp_work_results_heard_from(struct pp_work_results *results, int rank, double now_s)
{
    double *heard_s = &results->heard_s[rank];
    for (int i = results->next; i < results->unassigned; i++) {
        const struct slot *slot = result_slot(results, i);
        double from_s = slot->since_s > *heard_s ? slot->since_s : *heard_s;
        if (slot->rank == rank && now_s - from_s > results->longest_s)
            results->longest_s = now_s - from_s;
    }
    *heard_s = now_s;
}

bool pp_work_results_reassign(struct pp_work_results *results, int rank, double now_s,
                              int *index)
{
    double patience_s = silence_s + silence_times * results->longest_s;
    int end = results->unassigned < results->end ? results->unassigned : results->end;
    for (int i = results->next; i < end; i++) {
        struct slot *slot = result_slot(results, i);
        double from_s = slot->since_s > results->heard_s[slot->rank]
                            ? slot->since_s
                            : results->heard_s[slot->rank];
        if (slot->done || slot->rank == rank || now_s - from_s < patience_s)
            continue;
        slot->rank = rank;
        slot->since_s = now_s;
        *index = i;
        return true;
    }
    return false;
}

enum pp_status pp_work_results_end(const struct pp_work_results *results, int *next,
                                   struct pp_error *err)
{
    *next = results->next;
    bool failed = results->status == PP_OK && results->failure != PP_OK
                  && !results->stopped && results->next == results->end;
    enum pp_status status = failed ? results->failure : results->status;
    if (status != PP_OK && err)
        *err = failed ? results->why : results->err;
    return status;
}
