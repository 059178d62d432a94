/* data_file.h - #fopen, #read, #write, #fclose: values from files.
 *
 * A file is found as by #include, and read value by value: floats, vectors and strings,
 * with or without commas in between. After the last value its name is undeclared, as in
 * POV-Ray, so that `defined` detects the end. A scene that is read writes no file:
 * #write is ignored.
 */
#ifndef RT_SCENE_DATA_FILE_H
#define RT_SCENE_DATA_FILE_H

#include "rt/scene/language/scene_block.h"

item_reader data_file_open, data_file_read, data_file_write, data_file_close;

#endif
