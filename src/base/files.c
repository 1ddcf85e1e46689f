/* Whole-file reading and atomic replacement (see files.h). */
#include "base/files.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { MAX_FILE_BYTES = 1 << 30 };

static int fail_errno(struct rl_error *error, const char *doing, const char *path)
{
    return rl_fail(error, RL_ERR_SYSTEM, "%s: cannot %s: %s", path, doing, strerror(errno));
}

static int read_all(int fd, char *data, size_t size, const char *path, struct rl_error *error)
{
    for (size_t done = 0; done < size;) {
        ssize_t n = read(fd, data + done, size - done);
        if (n < 0 && errno == EINTR)
            continue;
        if (n < 0)
            return fail_errno(error, "read", path);
        if (n == 0)
            return rl_fail(error, RL_ERR_SYSTEM, "%s: ended after %zu of %zu bytes while being read", path,
                           done, size);
        done += (size_t)n;
    }
    return RL_OK;
}

static int check_regular(int fd, size_t *size, const char *path, struct rl_error *error)
{
    struct stat info;
    if (fstat(fd, &info) != 0)
        return fail_errno(error, "inspect", path);
    if (!S_ISREG(info.st_mode))
        return rl_fail(error, RL_ERR_INPUT, "%s: not a regular file", path);
    if (info.st_size > MAX_FILE_BYTES)
        return rl_fail(error, RL_ERR_INPUT, "%s: %lld bytes, at most 1 GiB is read", path,
                       (long long)info.st_size);
    *size = (size_t)info.st_size;
    return RL_OK;
}

int rl_file_read(char **data, size_t *size, const char *path, struct rl_error *error)
{
    /* Without O_NONBLOCK a named pipe would be waited for. */
    int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (fd < 0)
        return rl_fail(error, RL_ERR_INPUT, "%s: cannot open: %s", path, strerror(errno));
    size_t bytes = 0;
    char *buffer = NULL;
    int status = check_regular(fd, &bytes, path, error);
    if (status == RL_OK) {
        buffer = malloc(bytes + 1);
        status = buffer ? read_all(fd, buffer, bytes, path, error) : rl_fail_memory(error, path);
    }
    close(fd);
    if (!buffer || status != RL_OK) {
        free(buffer);
        return status;
    }
    buffer[bytes] = '\0';
    *data = buffer;
    *size = bytes;
    return RL_OK;
}

enum { HOST_MAX = 64 };

/* Whose a temporary file is: this machine's, by its name, and this process's, by its number. */
static void host_name(char host[HOST_MAX])
{
    if (gethostname(host, HOST_MAX) != 0)
        *host = '\0';
    host[HOST_MAX - 1] = '\0';
}

/* Removes what writers of the same file left that were killed: temporary files of processes that this machine no longer has. `prefix` is
 * all of their name before the process. */
static void remove_orphans(const char *folder, const char *prefix)
{
    DIR *dir = opendir(*folder ? folder : ".");
    if (!dir)
        return;
    for (const struct dirent *entry; (entry = readdir(dir));) {
        size_t n = strlen(prefix);
        char path[PATH_MAX], *end = NULL;
        if (strncmp(entry->d_name, prefix, n) != 0)
            continue;
        long process = strtol(entry->d_name + n, &end, 10);
        if (process <= 0 || (*end != '\0' && *end != '.') || kill((pid_t)process, 0) == 0 || errno != ESRCH)
            continue;
        if (snprintf(path, sizeof path, "%s%s", folder, entry->d_name) < (int)sizeof path)
            unlink(path);
    }
    closedir(dir);
}

int rl_file_begin(char temporary[], size_t size, const char *path, struct rl_error *error)
{
    struct stat info;
    bool exists = stat(path, &info) == 0;
    if (exists && S_ISDIR(info.st_mode))
        return rl_fail(error, RL_ERR_SYSTEM, "%s: is a directory, a file name is expected", path);
    /* Renaming over /dev/null would replace the device. */
    if (exists && !S_ISREG(info.st_mode))
        return rl_fail(error, RL_ERR_SYSTEM,
                       "%s: is a device or pipe, which cannot be replaced; a file name is expected", path);
    const char *slash = strrchr(path, '/');
    const char *base = slash ? slash + 1 : path;
    if (!*base)
        return rl_fail(error, RL_ERR_SYSTEM, "'%s': a file name is expected", path);
    const char *dot = strrchr(base, '.');
    const char *extension = dot ? dot : "";
    char host[HOST_MAX], folder[PATH_MAX], prefix[PATH_MAX];
    host_name(host);
    snprintf(folder, sizeof folder, "%.*s", (int)(base - path), path);
    snprintf(prefix, sizeof prefix, ".%s.%s.", base, host);
    int n = snprintf(temporary, size, "%s%s%ld%s", folder, prefix, (long)getpid(), extension);
    if (n < 0 || (size_t)n >= size)
        return rl_fail(error, RL_ERR_SYSTEM, "%s: name too long", path);
    remove_orphans(folder, prefix);
    /* Creating it now finds an unwritable folder before any long work. */
    int fd = open(temporary, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (fd < 0)
        return fail_errno(error, "write", path);
    close(fd);
    return RL_OK;
}

int rl_file_commit(const char *temporary, const char *path, struct rl_error *error)
{
    int fd = open(temporary, O_WRONLY | O_CLOEXEC);
    int status = RL_OK;
    if (fd < 0 || fsync(fd) != 0)
        status = fail_errno(error, "flush", path);
    if (fd >= 0 && close(fd) != 0 && status == RL_OK)
        status = fail_errno(error, "close", path);
    if (status == RL_OK && rename(temporary, path) != 0)
        status = fail_errno(error, "replace", path);
    if (status != RL_OK)
        rl_file_abandon(temporary);
    return status;
}

void rl_file_abandon(const char *temporary)
{
    unlink(temporary);
}

static int write_all(const char *temporary, const char *data, size_t size, const char *path,
                     struct rl_error *error)
{
    int fd = open(temporary, O_WRONLY | O_TRUNC | O_CLOEXEC);
    if (fd < 0)
        return fail_errno(error, "write", path);
    int status = RL_OK;
    for (size_t done = 0; done < size && status == RL_OK;) {
        ssize_t n = write(fd, data + done, size - done);
        if (n < 0 && errno != EINTR)
            status = fail_errno(error, "write", path);
        else if (n > 0)
            done += (size_t)n;
    }
    if (close(fd) != 0 && status == RL_OK)
        status = fail_errno(error, "close", path);
    return status;
}

int rl_file_write(const char *path, const void *data, size_t size, struct rl_error *error)
{
    char temporary[PATH_MAX];
    int status = rl_file_begin(temporary, sizeof temporary, path, error);
    if (status != RL_OK)
        return status;
    status = write_all(temporary, data, size, path, error);
    if (status != RL_OK) {
        rl_file_abandon(temporary);
        return status;
    }
    return rl_file_commit(temporary, path, error);
}

int rl_directory_create(const char *path, struct rl_error *error)
{
    char partial[PATH_MAX];
    size_t length = strlen(path);
    if (length == 0 || length >= sizeof partial)
        return rl_fail(error, RL_ERR_SYSTEM, "'%s': not a usable folder name", path);
    memcpy(partial, path, length + 1);
    for (size_t i = 1; i <= length; i++) {
        if (partial[i] != '/' && partial[i] != '\0')
            continue;
        char kept = partial[i];
        partial[i] = '\0';
        if (mkdir(partial, 0777) != 0 && errno != EEXIST)
            return fail_errno(error, "create the folder", partial);
        partial[i] = kept;
    }
    struct stat info;
    if (stat(path, &info) != 0 || !S_ISDIR(info.st_mode))
        return rl_fail(error, RL_ERR_SYSTEM, "%s: exists and is not a folder", path);
    return RL_OK;
}
