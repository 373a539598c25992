/* deal_book.h - of a deal: which indices are dealt out, which are done, which taken. */
#ifndef PP_MODEL_BASE_DEAL_BOOK_H
#define PP_MODEL_BASE_DEAL_BOOK_H

#include "model/base/deal.h"

/* What one index gave. */
struct pp_deal_gift {
    char *bytes; /* NULL where it failed */
    size_t length;
    enum pp_status status;
    struct pp_error err;
};

struct pp_deal_book;

/* The deal must outlive it. */
enum pp_status pp_deal_book_create(struct pp_deal_book **book,
                                   const struct pp_deal *deal, struct pp_error *err);
void pp_deal_book_destroy(struct pp_deal_book *book); /* NULL is allowed */

/* Works an index out. */
void pp_deal_book_work(const struct pp_deal *deal, int worker, int index,
                       struct pp_deal_gift *gift);

/* An index's turn is over: takes what can be taken, and looks whether to go on. The
 * bytes are the book's from here on. An index that is known already is passed over. */
void pp_deal_book_enter(struct pp_deal_book *book, int index,
                        const struct pp_deal_gift *gift);

/* Nothing more is to be dealt out: all is taken, something failed, or it was stopped. */
bool pp_deal_book_is_over(const struct pp_deal_book *book);

/* Up to `most` indices that nobody has been dealt yet, for `rank`, at the time `now_s`:
 * *index and the following; returns how many, 0 where all are dealt out. */
int pp_deal_book_give(struct pp_deal_book *book, int rank, int most, double now_s,
                      int *index);

/* The first index that another rank has had for so long that it has to be thought lost;
 * it is then `rank`'s. False: there is none. */
bool pp_deal_book_give_again(struct pp_deal_book *book, int rank, double now_s,
                             int *index);

/* There was a message of that rank's at that time. */
void pp_deal_book_hear(struct pp_deal_book *book, int rank, double now_s);

/* How many indices nobody has been dealt yet. */
int pp_deal_book_left(const struct pp_deal_book *book);

/* The index after the last that was taken; and what became of it all. */
enum pp_status pp_deal_book_end(const struct pp_deal_book *book, int *next,
                                struct pp_error *err);

#endif
