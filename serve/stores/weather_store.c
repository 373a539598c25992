/* weather_store.c - see weather_store.h. */
#include "serve/stores/weather_store.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "serve/stores/sha256.h"

struct weather_file {
    char path[128], hash[65];
    uint64_t used;
};

struct pp_weather_store {
    pthread_mutex_t lock;
    char folder[40];
    struct weather_file files[PP_WEATHER_STORE_MOST];
    uint64_t uses;
};

struct pp_weather_store *pp_weather_store_create(void)
{
    struct pp_weather_store *store = calloc(1, sizeof *store);
    if (!store)
        return NULL;
    strcpy(store->folder, "/tmp/pepperpot-serve-XXXXXX");
    if (!mkdtemp(store->folder)) {
        free(store);
        return NULL;
    }
    pthread_mutex_init(&store->lock, NULL);
    return store;
}

void pp_weather_store_empty(struct pp_weather_store *store)
{
    for (int i = 0; i < PP_WEATHER_STORE_MOST; i++)
        if (store->files[i].hash[0])
            unlink(store->files[i].path);
    rmdir(store->folder);
}

void pp_weather_store_destroy(struct pp_weather_store *store)
{
    if (!store)
        return;
    pp_weather_store_empty(store);
    pthread_mutex_destroy(&store->lock);
    free(store);
}

/* Finds a file by its hash. The caller must hold the lock. */
static struct weather_file *find_file(struct pp_weather_store *store, const char *hash)
{
    for (int i = 0; i < PP_WEATHER_STORE_MOST; i++)
        if (store->files[i].hash[0] && strcmp(store->files[i].hash, hash) == 0)
            return &store->files[i];
    return NULL;
}

char *pp_weather_store_path(struct pp_weather_store *store, const char *hash)
{
    pthread_mutex_lock(&store->lock);
    struct weather_file *file = find_file(store, hash);
    if (file)
        file->used = ++store->uses;
    char *path = file ? strdup(file->path) : NULL;
    pthread_mutex_unlock(&store->lock);
    return path;
}

/* Stores the file in place of the least recently used one, unless it is already stored.
 * The caller must hold the lock. */
static bool keep_file(struct pp_weather_store *store, const char *hash,
                      const char *bytes, size_t length)
{
    struct weather_file *place = find_file(store, hash);
    if (place) {
        place->used = ++store->uses;
        return true;
    }
    place = store->files;
    for (int i = 0; i < PP_WEATHER_STORE_MOST; i++)
        if (store->files[i].used < place->used)
            place = &store->files[i];
    if (place->hash[0])
        unlink(place->path);
    place->hash[0] = '\0';
    snprintf(place->path, sizeof place->path, "%s/%.64s.epw", store->folder, hash);
    FILE *out = fopen(place->path, "we");
    bool good = out && fwrite(bytes, 1, length, out) == length;
    if (out && fclose(out) != 0)
        good = false;
    if (good) {
        strcpy(place->hash, hash);
        place->used = ++store->uses;
    }
    return good;
}

bool pp_weather_store_put(struct pp_task *task)
{
    struct pp_weather_store *store = task->server->weather;
    struct json_object *bytes = NULL, *answer;
    char hash[65];
    json_object_object_get_ex(task->body, "bytes", &bytes);
    const char *text = json_object_get_string(bytes);
    size_t length = (size_t)json_object_get_string_len(bytes);
    if (strncmp(text, "LOCATION,", 9) != 0) {
        pp_task_fail(task, MHD_HTTP_UNPROCESSABLE_CONTENT,
                     "expected a weather file in EnergyPlus format (EPW), which begins "
                     "with LOCATION");
        return true;
    }
    pp_sha256_hex(hash, text, length);
    pthread_mutex_lock(&store->lock);
    bool kept = keep_file(store, hash, text, length);
    pthread_mutex_unlock(&store->lock);
    if (!kept) {
        pp_task_fail(task, MHD_HTTP_INSUFFICIENT_STORAGE, "the file cannot be stored");
        return true;
    }
    answer = json_object_new_object();
    if (answer) {
        json_object_object_add(answer, "hash", json_object_new_string(hash));
        json_object_object_add(
            answer, "place",
            json_object_new_string_len(text + 9, (int)strcspn(text + 9, ",\r\n")));
    }
    pp_task_answer_json(task, MHD_HTTP_OK, answer);
    return true;
}
