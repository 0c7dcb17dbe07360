package org.sitaf.cli.terminal;

import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;

/** Words for failures of file operations, whose messages in Java often have only the path. */
public final class FileProblem {
  private FileProblem() {}

  /** Describes a failure of an input or output operation. */
  public static String of(Throwable failure) {
    Throwable cause = failure;
    while (cause instanceof java.io.UncheckedIOException && cause.getCause() != null) {
      cause = cause.getCause();
    }
    if (cause instanceof FileSystemException problem && problem.getReason() == null) {
      return problem.getMessage() + ": " + problemOf(problem);
    }
    String message = cause.getMessage();
    return message == null ? cause.getClass().getSimpleName() : message;
  }

  private static String problemOf(FileSystemException failure) {
    if (failure instanceof NoSuchFileException) {
      return "does not exist";
    }
    if (failure instanceof FileAlreadyExistsException) {
      return "exists already";
    }
    if (failure instanceof AccessDeniedException) {
      return "permission denied";
    }
    if (failure instanceof DirectoryNotEmptyException) {
      return "the folder is not empty";
    }
    if (failure instanceof NotDirectoryException) {
      return "is not a folder";
    }
    return failure.getClass().getSimpleName();
  }
}
