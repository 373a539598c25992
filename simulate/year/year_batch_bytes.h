/* year_batch_bytes.h - a randomisation as bytes of a file, the same on any machine:
 * the numbers of struct pp_year_batch, then its points, then its flags. */
#ifndef PP_SIMULATE_YEAR_YEAR_BATCH_BYTES_H
#define PP_SIMULATE_YEAR_YEAR_BATCH_BYTES_H

#include "simulate/year/year_batch.h"

/* Number of bytes of every randomisation of the task. */
size_t pp_year_batch_bytes_size(const struct pp_year_task *task);

/* Writes pp_year_batch_bytes_size bytes. */
void pp_year_batch_bytes_put(unsigned char *bytes, const struct pp_year_batch *batch,
                             const struct pp_year_task *task);

/* Reads pp_year_batch_bytes_size bytes; the caller clears *batch, even after a failure.
 * PP_BAD_INPUT if they are damaged. */
enum pp_status pp_year_batch_bytes_take(struct pp_year_batch *batch,
                                        const struct pp_year_task *task,
                                        const unsigned char *bytes,
                                        struct pp_error *err);

#endif
