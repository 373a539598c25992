/* error.h - how a function says that it could not do its work.
 *
 * What can fail returns a status and takes a struct pp_error last, which may be
 * NULL; the message is one sentence for people and names the file, line or value.
 */
#ifndef PP_MODEL_BASE_ERROR_H
#define PP_MODEL_BASE_ERROR_H

enum pp_status {
    PP_OK = 0,
    PP_BAD_INPUT,   /* the input or its data is wrong */
    PP_SYSTEM,      /* the machine failed: memory, disk, permission */
    PP_INTERRUPTED, /* stopped on request; the results so far are good */
};

struct pp_error {
    enum pp_status status;
    char message[1024];
};

/* Fills err (may be NULL) and returns status. */
enum pp_status pp_fail(struct pp_error *err, enum pp_status status, const char *format,
                       ...) __attribute__((format(printf, 3, 4)));

/* pp_fail for an allocation that was refused. */
enum pp_status pp_fail_memory(struct pp_error *err);

#endif
