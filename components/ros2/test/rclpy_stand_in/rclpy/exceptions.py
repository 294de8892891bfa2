"""Exceptions for parameters."""


class ParameterException(Exception):
    pass


class InvalidParameterTypeException(ParameterException):
    pass


class ParameterAlreadyDeclaredException(ParameterException):
    pass


class ParameterNotDeclaredException(ParameterException):
    pass
