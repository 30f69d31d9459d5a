/// A video file: raw frames go through a pipe to ffmpeg, which must be installed. The file has a
/// temporary name until it is complete.
#ifndef BALLOON_SHOW_VIDEO_H
#define BALLOON_SHOW_VIDEO_H

#include "base/fault.h"

/// Stands in the comment of every film and picture, so that the program knows its own.
#define VIDEO_MARK "made by balloon"

typedef struct VideoFormat {
    const char* ending;           ///< of the file's name, with the dot
    const char* muxer;            ///< ffmpeg's name of the container
    const char* const* arguments; ///< codec and filters, terminated by NULL
    bool even;                    ///< players need even sides
    bool add_comment;             ///< ffmpeg writes no comment into this format; video_close does
} VideoFormat;

extern const VideoFormat video_table[];
extern const int video_count;

/// Row by the ending of a file's name, or NULL.
const VideoFormat* video_find(const char* file);

typedef struct Video {
    FILE* pipe;       ///< raw frames, to ffmpeg
    FILE* messages;   ///< ffmpeg's messages, quoted in faults
    long process;     ///< ffmpeg's process id; 0: none
    size_t frame;     ///< size of a frame [bytes]
    bool add_comment; ///< ffmpeg wrote none
    char file[900];
    char temporary[1024]; ///< the name until the file is complete
} Video;

/// Start ffmpeg. A missing ffmpeg and a file that cannot be written are faults.
bool video_open(Video* video, const VideoFormat* format, const char* file, int width, int height,
                double fps, Fault* fault);

/// rgb: [height * width * 3], top row first.
bool video_add(Video* video, const unsigned char* rgb, Fault* fault);

/// End the video and wait for ffmpeg. If it fails, or `complete` is false, no file is left.
bool video_close(Video* video, bool complete, Fault* fault);

#endif
