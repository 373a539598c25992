/* mark_rank.h - how much a mark of a scale stands out. */
#ifndef PP_MODEL_MARK_RANK_H
#define PP_MODEL_MARK_RANK_H

enum pp_mark_rank { PP_MARK_FINE, PP_MARK_MIDDLE, PP_MARK_LABELLED };

#endif
