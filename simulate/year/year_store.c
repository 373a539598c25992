/* year_store.c - finds, reads and adds randomisations. */
#include "simulate/year/year_store.h"

#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

#include "model/base/array.h"
#include "model/base/thread_pool.h"
#include "simulate/sampling/little_endian.h"
#include "simulate/year/year_batch_bytes.h"

static const char magic[8] = {'P', 'P', 'D', 'C', 'O', 'E', 'F', 'F'};

/* The version is raised whenever a calculation gives other coefficients. */
enum {
    VERSION = 3,
    START = 8 + 4,
    NAME = 64,
    HEAD = 2 * 4 + NAME + 4 * 8 + 8 + 4 * 4 + 8 + 4 + 8
};

struct stored_batch {
    struct pp_year_origin origin;
    int index;
    off_t at; /* of the data */
    uint64_t size;
};

struct pp_year_store {
    FILE *file;
    const char *title;
    enum pp_year_store_use use;
    struct stored_batch *list;
    int count, capacity;
    off_t end;
};

/* ---- heads ---- */

static void put_batch_head(unsigned char *at, const struct stored_batch *batch)
{
    const struct pp_year_origin *origin = &batch->origin;
    const unsigned char *begin = at;
    pp_little_endian_put(&at, (uint64_t)origin->room, 4);
    pp_little_endian_put(&at, (uint64_t)origin->state, 4);
    memcpy(at, origin->name, NAME);
    at += NAME;
    pp_little_endian_put(&at, origin->scene, 8);
    pp_little_endian_put(&at, origin->light, 8);
    pp_little_endian_put(&at, origin->points, 8);
    pp_little_endian_put(&at, origin->groups, 8);
    pp_little_endian_put_double(&at, origin->north_rad);
    pp_little_endian_put(&at, (uint64_t)origin->point_count, 4);
    pp_little_endian_put(&at, (uint64_t)origin->group_count, 4);
    pp_little_endian_put(&at, (uint64_t)origin->patches, 4);
    pp_little_endian_put(&at, (uint64_t)origin->paths, 4);
    pp_little_endian_put(&at, origin->seed, 8);
    pp_little_endian_put(&at, (uint64_t)batch->index, 4);
    pp_little_endian_put(&at, batch->size, 8);
    pp_little_endian_put(&at, pp_little_endian_hash(VERSION, begin, HEAD), 8);
}

/* False if the head is damaged. */
static bool take_batch_head(const unsigned char *at, struct stored_batch *batch)
{
    struct pp_year_origin *origin = &batch->origin;
    uint64_t hash = pp_little_endian_hash(VERSION, at, HEAD);
    *batch = (struct stored_batch){.index = 0};
    origin->room = (int)pp_little_endian_take(&at, 4);
    origin->state = (int)pp_little_endian_take(&at, 4);
    memcpy(origin->name, at, NAME - 1);
    at += NAME;
    origin->scene = pp_little_endian_take(&at, 8);
    origin->light = pp_little_endian_take(&at, 8);
    origin->points = pp_little_endian_take(&at, 8);
    origin->groups = pp_little_endian_take(&at, 8);
    origin->north_rad = pp_little_endian_take_double(&at);
    origin->point_count = (int)pp_little_endian_take(&at, 4);
    origin->group_count = (int)pp_little_endian_take(&at, 4);
    origin->patches = (int)pp_little_endian_take(&at, 4);
    origin->paths = (int)pp_little_endian_take(&at, 4);
    origin->seed = pp_little_endian_take(&at, 8);
    batch->index = (int)pp_little_endian_take(&at, 4);
    batch->size = pp_little_endian_take(&at, 8);
    return hash == pp_little_endian_take(&at, 8) && batch->index >= 0
           && batch->index < PP_YEAR_BATCHES;
}

/* ---- origins ---- */

static bool is_same_room(const struct pp_year_origin *a, const struct pp_year_origin *b)
{
    return a->room == b->room && a->state == b->state;
}

/* Ignores the numbers of paths. */
static bool is_same(const struct pp_year_origin *a, const struct pp_year_origin *b)
{
    return is_same_room(a, b) && strcmp(a->name, b->name) == 0 && a->scene == b->scene
           && a->light == b->light && a->points == b->points && a->groups == b->groups
           && a->north_rad == b->north_rad && a->point_count == b->point_count
           && a->group_count == b->group_count && a->patches == b->patches
           && a->seed == b->seed;
}

static const struct stored_batch *find(const struct pp_year_store *store,
                                       const struct pp_year_origin *origin, int index)
{
    for (int i = 0; i < store->count; i++)
        if (store->list[i].index == index
            && store->list[i].origin.paths == origin->paths
            && is_same(&store->list[i].origin, origin))
            return &store->list[i];
    return NULL;
}

int pp_year_store_count(const struct pp_year_store *store,
                        const struct pp_year_origin *origin)
{
    int count = 0;
    for (int b = 0; b < PP_YEAR_BATCHES; b++)
        count += find(store, origin, b) != NULL;
    return count;
}

static enum pp_status fail_other(const struct pp_year_store *store,
                                 struct pp_error *err, const struct pp_year_origin *is,
                                 const struct pp_year_origin *expected)
{
    const char *title = store->title;
    if (strcmp(is->name, expected->name) != 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s: the coefficients are those of the room \"%s\"; expected "
                       "\"%s\"",
                       title, is->name, expected->name);
    if (is->patches != expected->patches)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s: the coefficients have %d sky patches; expected %d "
                       "(--patches)",
                       title, is->patches, expected->patches);
    if (is->seed != expected->seed)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s: the coefficients were calculated with the seed %llu; "
                       "expected %llu (--seed)",
                       title, (unsigned long long)is->seed,
                       (unsigned long long)expected->seed);
    const char *differs =
        is->point_count != expected->point_count || is->points != expected->points
            ? "for other points"
        : is->north_rad != expected->north_rad
            ? "with another bearing of the plan (north)"
        : is->scene != expected->scene
            ? "with other geometry or materials of the room or its surroundings"
        : is->light != expected->light
            ? "with another sky or ground reflectance in the room file"
            : "with other window groups";
    return pp_fail(err, PP_BAD_INPUT,
                   "%s: the coefficients of the room \"%s\" were calculated %s", title,
                   is->name, differs);
}

static enum pp_status check_complete(const struct pp_year_store *store,
                                     const struct pp_year_origin *origin, int *paths,
                                     struct pp_error *err)
{
    struct pp_year_origin stored = *origin;
    int most = 0;
    for (int i = store->count - 1; i >= 0; i--)
        if (is_same(&store->list[i].origin, origin)) {
            stored.paths = store->list[i].origin.paths;
            most = pp_year_store_count(store, &stored);
            if (most == PP_YEAR_BATCHES && (*paths == 0 || *paths == stored.paths)) {
                *paths = stored.paths;
                return PP_OK;
            }
        }
    if (most == PP_YEAR_BATCHES)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s: the coefficients were calculated with %d paths per point; "
                       "expected %d (--samples)",
                       store->title, stored.paths, *paths);
    return most > 0
               ? pp_fail(err, PP_BAD_INPUT,
                         "%s: the file has %d of the %d randomisations of the room "
                         "\"%s\"; expected the file of a finished calculation",
                         store->title, most, PP_YEAR_BATCHES, origin->name)
               : pp_fail(err, PP_BAD_INPUT,
                         "%s: the file has no coefficients of the room \"%s\"",
                         store->title, origin->name);
}

enum pp_status pp_year_store_check(const struct pp_year_store *store,
                                   const struct pp_year_origin *origin, int *paths,
                                   struct pp_error *err)
{
    bool has_state = false;
    for (int i = 0; i < store->count; i++) {
        const struct pp_year_origin *is = &store->list[i].origin;
        if (is_same_room(is, origin) && !is_same(is, origin))
            return fail_other(store, err, is, origin);
        has_state |= is_same_room(is, origin);
    }
    bool is_required = has_state || origin->state == 0;
    return store->use == PP_YEAR_STORE_READ && is_required
               ? check_complete(store, origin, paths, err)
               : PP_OK;
}

/* ---- the file ---- */

static enum pp_status fail_damaged(const struct pp_year_store *store,
                                   struct pp_error *err)
{
    return pp_fail(err, PP_BAD_INPUT, "%s: the file is damaged", store->title);
}

static enum pp_status fail_written(const struct pp_year_store *store,
                                   struct pp_error *err)
{
    return pp_fail(err, PP_SYSTEM, "%s cannot be written", store->title);
}

static enum pp_status write_bytes(const struct pp_year_store *store,
                                  const unsigned char *bytes, size_t size,
                                  struct pp_error *err)
{
    return fwrite(bytes, 1, size, store->file) == size ? PP_OK
                                                       : fail_written(store, err);
}

static enum pp_status remember(struct pp_year_store *store,
                               const struct stored_batch *batch, struct pp_error *err)
{
    enum pp_status status = pp_array_reserve(
        &store->list, &store->capacity, store->count + 1, sizeof *store->list, err);
    if (status != PP_OK)
        return status;
    store->list[store->count++] = *batch;
    store->end = batch->at + (off_t)batch->size + 8;
    return PP_OK;
}

/* Reads the heads up to the end of the file, or to a randomisation that was not written
 * completely. */
static enum pp_status read_heads(struct pp_year_store *store, struct pp_error *err)
{
    unsigned char head[HEAD + 8];
    if (fseeko(store->file, 0, SEEK_END) != 0)
        return pp_fail(err, PP_BAD_INPUT, "%s cannot be read", store->title);
    off_t length = ftello(store->file);
    while (length - store->end >= (off_t)sizeof head) {
        struct stored_batch batch;
        if (fseeko(store->file, store->end, SEEK_SET) != 0
            || fread(head, 1, sizeof head, store->file) != sizeof head)
            return pp_fail(err, PP_SYSTEM, "%s cannot be read", store->title);
        if (!take_batch_head(head, &batch))
            return fail_damaged(store, err);
        batch.at = store->end + (off_t)sizeof head;
        if (batch.size > (uint64_t)(length - batch.at)
            || (uint64_t)(length - batch.at) - batch.size < 8)
            break;
        enum pp_status status = remember(store, &batch, err);
        if (status != PP_OK)
            return status;
    }
    if (store->use == PP_YEAR_STORE_UPDATE && length > store->end
        && ftruncate(fileno(store->file), store->end) != 0)
        return fail_written(store, err);
    return PP_OK;
}

/* Reads the start of the file, or writes it if the file is empty. */
static enum pp_status begin(struct pp_year_store *store, struct pp_error *err)
{
    unsigned char start[START], *to = start + sizeof magic;
    size_t got = 0;
    if (store->use != PP_YEAR_STORE_WRITE)
        got = fread(start, 1, START, store->file);
    store->end = START;
    if (got > 0 || store->use == PP_YEAR_STORE_READ) {
        const unsigned char *at = start + sizeof magic;
        if (got < START || memcmp(start, magic, sizeof magic) != 0)
            return pp_fail(err, PP_BAD_INPUT,
                           "%s is not a file of daylight coefficients by pepperpot",
                           store->title);
        unsigned version = (unsigned)pp_little_endian_take(&at, 4);
        if (version != VERSION)
            return pp_fail(err, PP_BAD_INPUT,
                           "%s: the coefficients have version %u; this program reads "
                           "version %d",
                           store->title, version, VERSION);
        return read_heads(store, err);
    }
    memcpy(start, magic, sizeof magic);
    pp_little_endian_put(&to, VERSION, 4);
    return write_bytes(store, start, START, err);
}

enum pp_status pp_year_store_create(struct pp_year_store **store, FILE *file,
                                    const char *title, enum pp_year_store_use use,
                                    struct pp_error *err)
{
    *store = calloc(1, sizeof **store);
    if (!*store)
        return pp_fail_memory(err);
    (*store)->file = file;
    (*store)->title = title;
    (*store)->use = use;
    enum pp_status status = begin(*store, err);
    if (status != PP_OK) {
        pp_year_store_destroy(*store);
        *store = NULL;
    }
    return status;
}

void pp_year_store_destroy(struct pp_year_store *store)
{
    if (store)
        free(store->list);
    free(store);
}

/* ---- randomisations ---- */

static enum pp_status read_batch(const struct pp_year_store *store,
                                 const struct stored_batch *stored,
                                 unsigned char *bytes, size_t size,
                                 struct pp_error *err)
{
    if (stored->size != size)
        return fail_damaged(store, err);
    if (fseeko(store->file, stored->at, SEEK_SET) != 0
        || fread(bytes, 1, size + 8, store->file) != size + 8)
        return pp_fail(err, PP_SYSTEM, "%s cannot be read", store->title);
    const unsigned char *tail = bytes + size;
    return pp_little_endian_take(&tail, 8)
                   == pp_little_endian_hash(VERSION, bytes, size)
               ? PP_OK
               : fail_damaged(store, err);
}

/* bytes: `size` of them, and space for their hash. */
static enum pp_status add_batch(struct pp_year_store *store,
                                const struct pp_year_origin *origin, int index,
                                unsigned char *bytes, size_t size, struct pp_error *err)
{
    unsigned char head[HEAD + 8], *tail = bytes + size;
    struct stored_batch batch = {*origin, index, store->end + (off_t)sizeof head, size};
    put_batch_head(head, &batch);
    pp_little_endian_put(&tail, pp_little_endian_hash(VERSION, bytes, size), 8);
    if (store->use != PP_YEAR_STORE_WRITE
        && fseeko(store->file, store->end, SEEK_SET) != 0)
        return fail_written(store, err);
    enum pp_status status = write_bytes(store, head, sizeof head, err);
    if (status == PP_OK)
        status = write_bytes(store, bytes, size + 8, err);
    if (status == PP_OK && fflush(store->file) != 0)
        status = fail_written(store, err);
    return status == PP_OK ? remember(store, &batch, err) : status;
}

/* Reads the randomisation from the first store that has it; *found: one has it. */
static enum pp_status take_batch(const struct pp_year_stores *stores, int index,
                                 unsigned char *bytes, size_t size, bool *found,
                                 struct pp_error *err)
{
    *found = false;
    for (int i = 0; i < stores->count; i++) {
        const struct stored_batch *stored =
            find(stores->list[i], &stores->origin, index);
        if (!stored)
            continue;
        *found = true;
        return read_batch(stores->list[i], stored, bytes, size, err);
    }
    return PP_OK;
}

/* Adds the randomisation to the stores of that use, where it is missing. */
static enum pp_status add_to(const struct pp_year_stores *stores,
                             enum pp_year_store_use use, int index,
                             unsigned char *bytes, size_t size, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < stores->count && status == PP_OK; i++)
        if (stores->list[i]->use == use
            && !find(stores->list[i], &stores->origin, index))
            status =
                add_batch(stores->list[i], &stores->origin, index, bytes, size, err);
    return status;
}

enum pp_status pp_year_stores_batch(const struct pp_year_stores *stores,
                                    struct pp_year_batch *batch,
                                    const struct pp_year_task *task, int index,
                                    int worker, struct pp_thread_pool *pool,
                                    struct pp_error *err)
{
    if (!stores || stores->count == 0)
        return pp_year_batch_make(batch, task, index, worker, err);
    bool found = false;
    size_t size = pp_year_batch_bytes_size(task);
    unsigned char *bytes = malloc(size + 8);
    if (!bytes)
        return pp_fail_memory(err);
    pp_thread_pool_lock(pool);
    enum pp_status status = take_batch(stores, index, bytes, size, &found, err);
    pp_thread_pool_unlock(pool);
    if (status == PP_OK && found)
        status = pp_year_batch_bytes_take(batch, task, bytes, err);
    else if (status == PP_OK)
        status = pp_year_batch_make(batch, task, index, worker, err);
    if (status == PP_OK && !found) {
        pp_year_batch_bytes_put(bytes, batch, task);
        pp_thread_pool_lock(pool);
        status = add_to(stores, PP_YEAR_STORE_UPDATE, index, bytes, size, err);
        pp_thread_pool_unlock(pool);
    }
    free(bytes);
    return status;
}

enum pp_status pp_year_stores_write(const struct pp_year_stores *stores,
                                    const struct pp_year_batch *batches,
                                    const struct pp_year_task *task,
                                    struct pp_error *err)
{
    if (!stores || stores->count == 0)
        return PP_OK;
    size_t size = pp_year_batch_bytes_size(task);
    unsigned char *bytes = malloc(size + 8);
    enum pp_status status = bytes ? PP_OK : pp_fail_memory(err);
    for (int b = 0; b < PP_YEAR_BATCHES && status == PP_OK; b++) {
        pp_year_batch_bytes_put(bytes, &batches[b], task);
        status = add_to(stores, PP_YEAR_STORE_WRITE, b, bytes, size, err);
    }
    free(bytes);
    return status;
}
