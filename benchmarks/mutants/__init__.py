"""Mutation campaign: do the tests of the trusted part notice when one token of it is wrong?"""
