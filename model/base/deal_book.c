/* deal_book.c - a slot for every index; the slots before `next` have been taken. */
#include "model/base/deal_book.h"

#include <stdlib.h>

/* A rank is given up once it has been silent for longer than this, and than some times
 * the longest that any index took: a matter of time only, what is taken stays. */
static const double silence_s = 0.5, silence_times = 3.0;

struct slot {
    char *bytes; /* NULL: not done, failed, or taken */
    size_t length;
    double since_s; /* dealt out to `rank` */
    int rank;
    bool done;
};

struct pp_deal_book {
    const struct pp_deal *deal;
    struct slot *slots; /* from deal->first */
    double *heard_s;    /* of each rank, when last */
    double longest_s;   /* that an index took, as far as is known */
    int next;           /* to be taken */
    int undealt;        /* from here on */
    int end;            /* the deal's, or the first index that failed */
    bool stopped;
    enum pp_status status; /* of taking */
    struct pp_error err;
    enum pp_status failure; /* of index `end` */
    struct pp_error why;
};

static struct slot *slot_of(const struct pp_deal_book *book, int index)
{
    return &book->slots[index - book->deal->first];
}

enum pp_status pp_deal_book_create(struct pp_deal_book **book,
                                   const struct pp_deal *deal, struct pp_error *err)
{
    int count = deal->end > deal->first ? deal->end - deal->first : 0;
    struct pp_deal_book *made = calloc(1, sizeof *made);
    *book = NULL;
    if (!made)
        return pp_fail_memory(err);
    *made = (struct pp_deal_book){
        .deal = deal,
        .slots = calloc((size_t)count + 1, sizeof *made->slots),
        .heard_s =
            calloc(deal->ranks ? (size_t)deal->ranks->count : 1, sizeof *made->heard_s),
        .next = deal->first,
        .undealt = deal->first,
        .end = deal->first + count};
    if (!made->slots || !made->heard_s) {
        made->end = made->next;
        pp_deal_book_destroy(made);
        return pp_fail_memory(err);
    }
    *book = made;
    return PP_OK;
}

void pp_deal_book_destroy(struct pp_deal_book *book)
{
    if (!book)
        return;
    for (int i = 0; book->slots && i < book->deal->end - book->deal->first; i++)
        free(book->slots[i].bytes);
    free(book->slots);
    free(book->heard_s);
    free(book);
}

void pp_deal_book_work(const struct pp_deal *deal, int worker, int index,
                       struct pp_deal_gift *gift)
{
    *gift = (struct pp_deal_gift){0};
    gift->status =
        deal->work(deal->data, worker, index, &gift->bytes, &gift->length, &gift->err);
    if (gift->status != PP_OK) {
        free(gift->bytes);
        gift->bytes = NULL;
        gift->length = 0;
    }
}

/* Takes what has nothing missing before it. */
static void take(struct pp_deal_book *book)
{
    const struct pp_deal *deal = book->deal;
    while (book->status == PP_OK && book->next < book->end) {
        struct slot *slot = slot_of(book, book->next);
        if (!slot->done)
            return;
        book->status =
            deal->take(deal->data, book->next, slot->bytes, slot->length, &book->err);
        free(slot->bytes);
        slot->bytes = NULL;
        book->next += book->status == PP_OK;
    }
}

void pp_deal_book_enter(struct pp_deal_book *book, int index,
                        const struct pp_deal_gift *gift)
{
    const struct pp_deal *deal = book->deal;
    struct slot *slot = slot_of(book, index);
    if (slot->done) {
        free(gift->bytes);
        return;
    }
    slot->bytes = gift->bytes;
    slot->length = gift->length;
    slot->done = true;
    if (gift->status != PP_OK && index < book->end) {
        book->end = index;
        book->failure = gift->status;
        book->why = gift->err;
    }
    take(book);
    int count = deal->end - deal->first;
    if (!book->stopped && deal->look)
        book->stopped =
            !deal->look(deal->data, (double)(book->next - deal->first) / count);
}

bool pp_deal_book_is_over(const struct pp_deal_book *book)
{
    return book->stopped || book->status != PP_OK || book->next >= book->end;
}

int pp_deal_book_left(const struct pp_deal_book *book)
{
    return book->end > book->undealt ? book->end - book->undealt : 0;
}

int pp_deal_book_give(struct pp_deal_book *book, int rank, int most, double now_s,
                      int *index)
{
    int left = pp_deal_book_left(book), count = left < most ? left : most;
    *index = book->undealt;
    for (int i = 0; i < count; i++) {
        struct slot *slot = slot_of(book, book->undealt++);
        slot->rank = rank;
        slot->since_s = now_s;
    }
    pp_deal_book_hear(book, rank, now_s);
    return count;
}

void pp_deal_book_hear(struct pp_deal_book *book, int rank, double now_s)
{
    double *heard_s = &book->heard_s[rank];
    for (int i = book->next; i < book->undealt; i++) {
        const struct slot *slot = slot_of(book, i);
        double from_s = slot->since_s > *heard_s ? slot->since_s : *heard_s;
        if (slot->rank == rank && now_s - from_s > book->longest_s)
            book->longest_s = now_s - from_s;
    }
    *heard_s = now_s;
}

bool pp_deal_book_give_again(struct pp_deal_book *book, int rank, double now_s,
                             int *index)
{
    double patience_s = silence_s + silence_times * book->longest_s;
    int end = book->undealt < book->end ? book->undealt : book->end;
    for (int i = book->next; i < end; i++) {
        struct slot *slot = slot_of(book, i);
        double from_s = slot->since_s > book->heard_s[slot->rank]
                            ? slot->since_s
                            : book->heard_s[slot->rank];
        if (slot->done || slot->rank == rank || now_s - from_s < patience_s)
            continue;
        slot->rank = rank;
        slot->since_s = now_s;
        *index = i;
        return true;
    }
    return false;
}

enum pp_status pp_deal_book_end(const struct pp_deal_book *book, int *next,
                                struct pp_error *err)
{
    *next = book->next;
    bool failed = book->status == PP_OK && book->failure != PP_OK && !book->stopped
                  && book->next == book->end;
    enum pp_status status = failed ? book->failure : book->status;
    if (status != PP_OK && err)
        *err = failed ? book->why : book->err;
    return status;
}
