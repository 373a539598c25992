/* folder_way.h - the way from one folder to another, as what names files relative to a folder
 * needs it when it moves. */
#ifndef PP_MODEL_BASE_FOLDER_WAY_H
#define PP_MODEL_BASE_FOLDER_WAY_H

#include "model/base/error.h"

/* What has to stand before a path that is relative to the folder of the file `file`, so that
 * it leads to the same place from that of the file `moved`: "../plans/", or nothing where
 * they are in one folder or there is no such folder. Only the folders have to be there. *way
 * is the caller's; fails only where memory is out. */
enum pp_status pp_folder_way(char **way, const char *file, const char *moved,
                             struct pp_error *err);

#endif
