/* weather_store.h - weather files that were uploaded, by their hash. Inside serve/ only.
 *
 * They lie in a folder of the server's own, which goes with it. The store holds the last
 * ones used.
 */
#ifndef PP_SERVE_STORES_WEATHER_STORE_H
#define PP_SERVE_STORES_WEATHER_STORE_H

#include "serve/work/task.h"

enum { PP_WEATHER_STORE_MOST = 32 };

struct pp_weather_store *pp_weather_store_create(void); /* NULL: it cannot be made */
void pp_weather_store_destroy(struct pp_weather_store *store); /* NULL is allowed */
void pp_weather_store_empty(struct pp_weather_store *store);   /* removes the folder */

/* The path of the file of that hash; NULL: there is none. Good while the store lives: a file
 * that leaves the store may be gone, which the command then says. */
const char *pp_weather_store_path(struct pp_weather_store *store, const char *hash);

/* The endpoint: { "hash": "...", "place": "..." }. */
pp_task_run pp_weather_store_put;

#endif
