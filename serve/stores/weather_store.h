/* weather_store.h - stores uploaded weather files by their hash. For use inside serve/
 * only.
 *
 * The store keeps the most recently used files in a temporary folder, which is removed
 * when the server stops.
 */
#ifndef PP_SERVE_STORES_WEATHER_STORE_H
#define PP_SERVE_STORES_WEATHER_STORE_H

#include "serve/work/task.h"

enum { PP_WEATHER_STORE_MOST = 32 };

struct pp_weather_store *pp_weather_store_create(void);        /* NULL: the folder
                                                                * cannot be created, or
                                                                * out of memory */
void pp_weather_store_destroy(struct pp_weather_store *store); /* NULL is allowed */
void pp_weather_store_empty(struct pp_weather_store *store);   /* removes the folder */

/* Path of the file with that hash; NULL if there is none. The caller frees it. A later
 * upload may replace the file before a command opens it; that command then reports an
 * error. */
char *pp_weather_store_path(struct pp_weather_store *store, const char *hash);

/* Stores a weather file, and answers with { "hash": "...", "place": "..." }. */
pp_task_run pp_weather_store_put;

#endif
