/* work_results.h - results of a work queue by index, and the state of each index:
 * assigned, done or collected. */
#ifndef PP_MODEL_BASE_WORK_RESULTS_H
#define PP_MODEL_BASE_WORK_RESULTS_H

#include "model/base/work_queue.h"

/* The result of one index. */
struct pp_work_result {
    char *bytes; /* NULL: the index failed */
    size_t length;
    enum pp_status status;
    struct pp_error err;
};

struct pp_work_results;

/* Creates the slots; the queue must outlive them. */
enum pp_status pp_work_results_create(struct pp_work_results **results,
                                      const struct pp_work_queue *queue,
                                      struct pp_error *err);
void pp_work_results_destroy(struct pp_work_results *results); /* NULL is allowed */

/* Computes the result of an index. */
void pp_work_results_work(const struct pp_work_queue *queue, int worker, int index,
                          struct pp_work_result *result);

/* Stores the result of an index and takes ownership of its bytes; then collects all
 * consecutive results, and checks whether to continue. A second result of an index is
 * dropped. */
void pp_work_results_enter(struct pp_work_results *results, int index,
                           const struct pp_work_result *result);

/* True if everything is collected, something has failed, or the queue was stopped. */
bool pp_work_results_is_over(const struct pp_work_results *results);

/* Assigns up to `most` unassigned indices to `rank`, at time `now_s`, beginning with
 * *index. Returns their number; 0 if all are assigned. */
int pp_work_results_assign(struct pp_work_results *results, int rank, int most,
                           double now_s, int *index);

/* Assigns to `rank` the first index of a rank that counts as lost. False if there is
 * none. */
bool pp_work_results_reassign(struct pp_work_results *results, int rank, double now_s,
                              int *index);

/* Records the time of a message from `rank`. */
void pp_work_results_heard_from(struct pp_work_results *results, int rank,
                                double now_s);

/* Number of unassigned indices. */
int pp_work_results_unassigned(const struct pp_work_results *results);

/* Returns the status of the queue. *next: the index after the last one collected. */
enum pp_status pp_work_results_end(const struct pp_work_results *results, int *next,
                                   struct pp_error *err);

#endif
