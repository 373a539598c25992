/* mpirun_module.c - messages between ranks by MPI; no other file uses MPI. One thread
 * of each rank calls these functions.
 *
 * Started with --enable-recovery, Open MPI 4 continues without a rank that was killed.
 * Messages to that rank are lost, and MPI_Finalize does not wait for it. Therefore no
 * function in this file waits for another rank.
 */
#include "cli/ranks/mpirun.h"

#include <limits.h>
#include <mpi.h>
#include <stdlib.h>
#include <string.h>

enum { TAG = 1 };

/* A message that is being sent; element of a list. */
struct sending {
    struct sending *next;
    MPI_Request request;
    char bytes[];
};

struct post {
    struct sending *sendings;
};

/* Frees messages that have been sent. */
static void sweep(struct post *post)
{
    struct sending **place = &post->sendings;
    while (*place) {
        struct sending *sending = *place;
        int gone = 0;
        if (MPI_Test(&sending->request, &gone, MPI_STATUS_IGNORE) == MPI_SUCCESS
            && !gone) {
            place = &sending->next;
            continue;
        }
        *place = sending->next;
        free(sending);
    }
}

static enum pp_status post_send(void *data, int to, const void *bytes, size_t length,
                                struct pp_error *err)
{
    struct post *post = data;
    sweep(post);
    if (length > INT_MAX)
        return pp_fail(err, PP_SYSTEM, "the message has %zu bytes, too many for MPI",
                       length);
    struct sending *sending = malloc(sizeof *sending + length);
    if (!sending)
        return pp_fail_memory(err);
    memcpy(sending->bytes, bytes, length);
    if (MPI_Isend(sending->bytes, (int)length, MPI_BYTE, to, TAG, MPI_COMM_WORLD,
                  &sending->request)
        != MPI_SUCCESS) {
        free(sending);
        return PP_OK; /* the receiving rank has ended */
    }
    sending->next = post->sendings;
    post->sendings = sending;
    return PP_OK;
}

static enum pp_status post_receive(void *data, int *from, char **bytes, size_t *length,
                                   struct pp_error *err)
{
    MPI_Status status;
    int there = 0, count = 0;
    *bytes = NULL;
    sweep(data);
    if (MPI_Iprobe(MPI_ANY_SOURCE, TAG, MPI_COMM_WORLD, &there, &status) != MPI_SUCCESS
        || !there)
        return PP_OK;
    MPI_Get_count(&status, MPI_BYTE, &count);
    *bytes = malloc((size_t)count + 1);
    if (!*bytes)
        return pp_fail_memory(err);
    *from = status.MPI_SOURCE;
    *length = (size_t)count;
    if (MPI_Recv(*bytes, count, MPI_BYTE, *from, TAG, MPI_COMM_WORLD, &status)
        != MPI_SUCCESS) {
        free(*bytes);
        *bytes = NULL;
    }
    return PP_OK;
}

/* Ends MPI. Messages not yet sent are addressed to ranks that have ended, and are
 * discarded. */
static void end(void *data)
{
    struct post *post = data;
    sweep(post);
    MPI_Finalize();
    while (post->sendings) {
        struct sending *sending = post->sendings;
        post->sendings = sending->next;
        free(sending);
    }
    free(post);
}

int pp_mpirun_module(struct pp_ranks *ranks, void (**ending)(void *data))
{
    int level;
    *ending = NULL;
    int failed = MPI_Init_thread(NULL, NULL, MPI_THREAD_FUNNELED, &level);
    if (failed != MPI_SUCCESS)
        return failed;
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    struct post *post = calloc(1, sizeof *post);
    if (!post || level < MPI_THREAD_FUNNELED) {
        free(post);
        MPI_Finalize();
        return MPI_ERR_OTHER;
    }
    *ranks =
        (struct pp_ranks){.send = post_send, .receive = post_receive, .data = post};
    MPI_Comm_rank(MPI_COMM_WORLD, &ranks->rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks->count);
    *ending = end;
    return 0;
}
